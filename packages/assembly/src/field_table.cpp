#include "hawser/assembly/field_table.hpp"

#include <algorithm>
#include <numeric>

#include "hawser/base/error.hpp"

namespace hawser {

namespace {

bool agree(const FieldDescription& field, RateRule rule, const FieldUse& use) {
  return field.components == use.components && field.basis == use.basis && field.unit == use.unit &&
         field.residual_unit == use.residual_unit && field.split == use.split &&
         rule == use.rate_rule;
}

[[noreturn]] void throw_conflict(const PhysicsModule& module, const FieldUse& use) {
  throw PluginError("module <" + module.name + "> and another one describe the field '" + use.name +
                    "' differently: unit, components, basis, split and rate must agree");
}

}  // namespace

FieldTable gather_fields(const std::vector<PhysicsModule>& modules) {
  struct Entry {
    FieldDescription description;
    RateRule rule;
    bool kinematic;
  };
  std::vector<Entry> entries;
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels)
      for (const FieldUse& use : kernel->fields()) {
        if (use.role == Role::reads) continue;
        auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& e) { return e.description.name == use.name; });
        if (entry == entries.end()) {
          entries.push_back({{use.name,
                              use.unit,
                              use.residual_unit,
                              use.components,
                              use.basis,
                              use.split,
                              {},
                              use.follows == nullptr ? "" : use.follows},
                             use.rate_rule,
                             false});
          entry = entries.end() - 1;
        }
        FieldDescription& field = entry->description;
        if (!agree(field, entry->rule, use)) throw_conflict(module, use);
        entry->kinematic = entry->kinematic || use.role == Role::kinematic;
        if (std::find(field.domains.begin(), field.domains.end(), kernel->domain()) ==
            field.domains.end())
          field.domains.push_back(kernel->domain());
      }
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels)
      for (const FieldUse& use : kernel->fields())
        for (const Entry& entry : entries)
          if (entry.description.name == use.name && !agree(entry.description, entry.rule, use))
            throw_conflict(module, use);
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    if (a.kinematic != b.kinematic) return a.kinematic;
    return a.description.components > b.description.components;
  });
  FieldTable table;
  for (Entry& entry : entries) {
    table.fields.push_back(std::move(entry.description));
    table.rate_rules.push_back(entry.rule);
  }
  return table;
}

}  // namespace hawser
