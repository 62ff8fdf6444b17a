#include <algorithm>
#include <set>
#include <string_view>

#include "hawser/assembly/connect_properties.hpp"
#include "hawser/base/error.hpp"

namespace hawser {
namespace {

/// A name that is misspelt would be supplied to nobody, without a word.
void check_is_used(const PhysicsModule& supplier, const PropertySource& source,
                   const std::vector<PhysicsModule>& modules, Diagnostics& diagnostics) {
  const PropertyUse wanted = source.property();
  std::set<std::string> names;
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels)
      for (const PropertyUse& use : kernel->properties().uses()) {
        const bool is_new = names.insert(use.name).second;
        if (std::string_view(use.name) != wanted.name) continue;
        if (is_new) source.check_unit(use.unit, diagnostics);
        const bool same_unit = *wanted.unit == '\0' || std::string_view(use.unit) == wanted.unit;
        if (same_unit && use.components == wanted.components) continue;
        if (*wanted.unit == '\0') {
          diagnostics.error(supplier.location, "'" + std::string(use.name) + "' has " +
                                                   std::to_string(use.components) +
                                                   " components, and here are " +
                                                   std::to_string(wanted.components) +
                                                   "; a semicolon sets expressions apart");
          return;
        }
        throw PluginError(named(supplier) + " supplies '" + wanted.name + "' in " + wanted.unit +
                          " with " + std::to_string(wanted.components) + " components, and " +
                          named(module) + " uses it in " + use.unit + " with " +
                          std::to_string(use.components));
      }
  const std::vector<std::string> known(names.begin(), names.end());
  if (names.count(wanted.name) == 0)
    diagnostics.error(supplier.location, named(supplier) + " supplies '" + wanted.name +
                                             "', which no module of this run uses; used are " +
                                             listed(known) + did_you_mean(wanted.name, known));
}

}  // namespace

void resolve_properties(std::vector<PhysicsModule>& modules, Diagnostics& diagnostics) {
  std::vector<FieldUse> fields;
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels)
      for (const FieldUse& use : kernel->fields())
        if (!only_reads(use.role)) fields.push_back(use);
  for (const PhysicsModule& module : modules)
    for (const Supply& supply : module.supplies)
      supply.source->resolve(fields, diagnostics);
  for (const PhysicsModule& module : modules)
    for (const Supply& supply : module.supplies)
      check_is_used(module, *supply.source, modules, diagnostics);
}

}  // namespace hawser
