#include "hawser/assembly/governance.hpp"

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

/// Calls visit(kernel use, first row) for every owned node of every field that a module writes or
/// drives.
template <class Visit>
void visit_rows(const DofMap& dofs, const PhysicsModule& module, Visit&& visit) {
  std::vector<LocalIndex> first_rows;
  for (const auto& kernel : module.kernels) {
    const Region& region = dofs.mesh().region(kernel->domain());
    for (const FieldUse& use : kernel->fields()) {
      if (only_reads(use.role)) continue;
      const int field = dofs.find(use.name);
      for (LocalIndex cell = 0; cell < region.size(); ++cell) {
        first_rows.clear();
        dofs.append_cell_rows(field, region, cell, first_rows);
        for (const LocalIndex row : first_rows)
          if (row >= 0 && row < dofs.owned()) visit(use, row);
      }
    }
  }
}

bool drives_a_structure(const PhysicsModule& module) {
  for (const auto& kernel : module.kernels)
    for (const FieldUse& use : kernel->fields())
      if (use.role == Role::kinematic) return true;
  return false;
}

/// Calls visit(module index, use, row) for every owned row that a module writes or drives.
template <class Visit>
void visit_all(const DofMap& dofs, const std::vector<PhysicsModule>& modules, Visit&& visit) {
  for (std::size_t m = 0; m < modules.size(); ++m)
    visit_rows(dofs, modules[m], [&](const FieldUse& use, LocalIndex first) {
      for (int c = 0; c < use.components; ++c)
        visit(static_cast<int>(m), use, static_cast<std::size_t>(first + c));
    });
}

void claim_rows(const DofMap& dofs, const std::vector<PhysicsModule>& modules, Governance& result) {
  visit_all(dofs, modules, [&](int /*module*/, const FieldUse& use, std::size_t row) {
    if (use.role == Role::kinematic) result.governor[row] = Governance::kinematic;
  });
  std::string conflict;
  visit_all(dofs, modules, [&](int module, const FieldUse& use, std::size_t row) {
    int& governor = result.governor[row];
    if (use.role != Role::governs || governor == Governance::kinematic || governor == module)
      return;
    if (governor == Governance::shared) {
      governor = module;
      return;
    }
    const PhysicsModule& first = modules[static_cast<std::size_t>(governor)];
    const PhysicsModule& second = modules[static_cast<std::size_t>(module)];
    conflict = second.location.text() + ": <" + second.name + "> governs the field '" + use.name +
               "' at nodes where <" + first.name + "> of " + first.location.text() +
               " does already; let one of them cover both regions";
  });
  dofs.mesh().communicator.together([&] {
    if (!conflict.empty()) throw DeckError(conflict);
  });
}

// A node of a structure belongs to the structure's block with all that moves with it.
void assign_blocks(const DofMap& dofs, const std::vector<PhysicsModule>& modules,
                   Governance& result) {
  const auto on_structure = [&](std::size_t row) {
    const RowInfo& info = dofs.info(static_cast<LocalIndex>(row));
    for (int field = 0; field < static_cast<int>(dofs.fields().size()); ++field) {
      const LocalIndex first = dofs.first_row(field, info.kind, info.point);
      if (first >= 0 && result.governor[static_cast<std::size_t>(first)] == Governance::kinematic)
        return true;
    }
    return false;
  };
  std::vector<char> drives;
  for (const PhysicsModule& module : modules)
    drives.push_back(drives_a_structure(module) ? 1 : 0);
  visit_all(dofs, modules, [&](int module, const FieldUse& /*use*/, std::size_t row) {
    int& block = result.block_of_row[row];
    if (result.governor[row] >= 0)
      block = result.governor[row];
    else if (block < 0 || (drives[static_cast<std::size_t>(module)] != 0 && on_structure(row)))
      block = module;
  });
}

}  // namespace

Governance find_governors(const DofMap& dofs, const std::vector<PhysicsModule>& modules) {
  const auto owned = static_cast<std::size_t>(dofs.owned());
  Governance result{std::vector<int>(owned, Governance::shared), std::vector<int>(owned, -1)};
  claim_rows(dofs, modules, result);
  assign_blocks(dofs, modules, result);
  return result;
}

}  // namespace hawser
