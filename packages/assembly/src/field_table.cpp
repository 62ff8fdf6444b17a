#include "hawser/assembly/field_table.hpp"

#include <algorithm>

#include "hawser/base/error.hpp"
#include "hawser/deck/diagnostics.hpp"

namespace hawser {
namespace {

struct Entry {
  FieldDescription description;
  RateRule rule;
  bool kinematic = false;
  // Who wishes what, null: nobody so far.
  const PhysicsModule* wants_basis = nullptr;
  const PhysicsModule* wants_numbering = nullptr;
};

bool agree(const Entry& entry, const FieldUse& use) {
  const FieldDescription& field = entry.description;
  return field.components == use.components && field.unit == use.unit &&
         field.residual_unit == use.residual_unit && entry.rule == use.rate_rule;
}

template <class Visit>
void each_use(const std::vector<PhysicsModule>& modules, Visit&& visit) {
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels)
      for (const FieldUse& use : kernel->fields())
        visit(module, *kernel, use);
}

class Gathering {
 public:
  Gathering(const std::vector<PhysicsModule>& modules, const std::vector<FieldDeck>& decisions)
      : decisions_(decisions) {
    each_use(modules, [&](const PhysicsModule& module, const Kernel& kernel, const FieldUse& use) {
      if (!only_reads(use.role)) add(module, kernel, use);
    });
    decide();
    each_use(modules, [&](const PhysicsModule& module, const Kernel&, const FieldUse& use) {
      check(module, use);
    });
    diagnostics_.throw_if_any();
    std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
      if (a.kinematic != b.kinematic) return a.kinematic;
      return a.description.components > b.description.components;
    });
  }

  FieldTable table() const {
    FieldTable table;
    for (const Entry& entry : entries_) {
      table.fields.push_back(entry.description);
      table.rate_rules.push_back(entry.rule);
    }
    return table;
  }

 private:
  Entry* find(const std::string& name) {
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.description.name == name;
    });
    return found == entries_.end() ? nullptr : &*found;
  }

  const FieldDeck* decision(const std::string& name) const {
    const auto found = std::find_if(decisions_.begin(), decisions_.end(),
                                    [&](const FieldDeck& deck) { return deck.name.value == name; });
    return found == decisions_.end() ? nullptr : &*found;
  }

  void add(const PhysicsModule& module, const Kernel& kernel, const FieldUse& use) {
    Entry* entry = find(use.name);
    if (entry == nullptr) {
      Entry fresh;
      fresh.description = {use.name, use.unit, use.residual_unit, use.components};
      if (use.follows != nullptr) fresh.description.follows = use.follows;
      fresh.rule = use.rate_rule;
      entries_.push_back(fresh);
      entry = &entries_.back();
    }
    FieldDescription& field = entry->description;
    field.has_level = field.has_level || use.has_level;
    field.places_nodes = field.places_nodes || use.places_nodes;
    entry->kinematic = entry->kinematic || use.role == Role::kinematic;
    if (std::find(field.domains.begin(), field.domains.end(), kernel.domain()) ==
        field.domains.end())
      field.domains.push_back(kernel.domain());
    const FieldDeck* const deck = decision(field.name);
    if (deck == nullptr || !deck->basis)
      take_wish(use.basis, module, "basis", field.name, field.basis, entry->wants_basis);
    if (deck == nullptr || !deck->numbering)
      take_wish(use.numbering, module, "numbering", field.name, field.numbering,
                entry->wants_numbering);
  }

  template <class T>
  void take_wish(const std::optional<T>& wish, const PhysicsModule& module, const std::string& what,
                 const std::string& name, T& agreed, const PhysicsModule*& who) {
    if (!wish) return;
    if (who != nullptr && *wish != agreed)
      diagnostics_.error(
          module.location,
          "module '" + module.name + "' wishes the " + what + " " + to_string(*wish) +
              " for the field '" + name + "', and module '" + who->name + "' " + to_string(agreed) +
              "; say which with <field name=\"" + name + "\" " + what + "=\"...\"/>");
    if (who != nullptr) return;
    who = &module;
    agreed = *wish;
  }

  void decide() {
    for (const FieldDeck& deck : decisions_) {
      Entry* const entry = find(deck.name.value);
      if (entry == nullptr) {
        diagnostics_.error(deck.name.location, "no module solves for a field '" + deck.name.value +
                                                   "'" + there_are(deck.name.value));
        continue;
      }
      FieldDescription& field = entry->description;
      field.basis = deck.basis.value_or(field.basis);
      field.numbering = deck.numbering.value_or(field.numbering);
      if (field.name == field_name::displacement && field.numbering != Numbering::continuous)
        diagnostics_.error(deck.name.location,
                           "the displacement moves the mesh, which stays whole at slits: its "
                           "numbering is continuous");
    }
  }

  void check(const PhysicsModule& module, const FieldUse& use) {
    const Entry* const entry = find(use.name);
    if (entry == nullptr) {
      if (use.role == Role::reads)
        diagnostics_.error(module.location, named(module) + " reads the field '" + use.name +
                                                "', which no module solves for" +
                                                there_are(use.name));
      return;
    }
    if (!agree(*entry, use))
      throw PluginError(named(module) + " and another one describe the field '" + use.name +
                        "' differently: unit, components and rate must agree");
    if (use.needs_basis && use.basis && *use.basis != entry->description.basis)
      diagnostics_.error(module.location, named(module) + " is written for the field '" + use.name +
                                              "' in " + to_string(*use.basis) + ", and it is in " +
                                              to_string(entry->description.basis));
    const Entry* const followed =
        use.role == Role::kinematic && use.follows != nullptr ? find(use.follows) : nullptr;
    if (followed != nullptr && followed->description.basis != entry->description.basis)
      diagnostics_.error(module.location,
                         named(module) + " is a structure, whose '" + use.name + "' is in " +
                             to_string(entry->description.basis) + " and '" + use.follows +
                             "' in " + to_string(followed->description.basis) + "; <field name=\"" +
                             use.name + "\" basis=\"" + to_string(followed->description.basis) +
                             "\"/> gives both the same basis");
  }

  std::string there_are(const std::string& wanted) const {
    std::vector<std::string> names;
    for (const Entry& entry : entries_)
      names.push_back(entry.description.name);
    return "; there are " + listed(names) + did_you_mean(wanted, names);
  }

  const std::vector<FieldDeck>& decisions_;
  std::vector<Entry> entries_;
  Diagnostics diagnostics_;
};

}  // namespace

FieldTable gather_fields(const std::vector<PhysicsModule>& modules,
                         const std::vector<FieldDeck>& decisions) {
  return Gathering(modules, decisions).table();
}

}  // namespace hawser
