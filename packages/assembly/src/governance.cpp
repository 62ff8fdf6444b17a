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
    const Region& region = dofs.mesh().region(kernel->region());
    for (const FieldUse& use : kernel->fields()) {
      if (use.role == Role::reads) continue;
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

}  // namespace

Governance find_governors(const DofMap& dofs, const std::vector<PhysicsModule>& modules) {
  const auto owned = static_cast<std::size_t>(dofs.owned());
  Governance result{std::vector<int>(owned, Governance::shared), std::vector<int>(owned, -1)};
  std::string conflict;
  for (int m = 0; m < static_cast<int>(modules.size()); ++m) {
    visit_rows(dofs, modules[static_cast<std::size_t>(m)],
               [&](const FieldUse& use, LocalIndex row) {
                 for (int c = 0; c < use.components; ++c) {
                   const auto r = static_cast<std::size_t>(row + c);
                   int& governor = result.governor[r];
                   if (use.role == Role::kinematic)
                     governor = Governance::kinematic;
                   else if (use.role == Role::governs && governor == Governance::shared)
                     governor = m;
                   else if (use.role == Role::governs && governor >= 0 && governor != m)
                     conflict = "modules <" + modules[static_cast<std::size_t>(governor)].name +
                                "> and <" + modules[static_cast<std::size_t>(m)].name +
                                "> both govern the field '" + use.name +
                                "' on the same nodes; give them separate regions";
                   if (result.block_of_row[r] < 0) result.block_of_row[r] = m;
                 }
               });
  }
  dofs.mesh().communicator.together([&] {
    if (!conflict.empty()) throw DeckError(conflict);
  });
  // A node of a structure belongs to the structure's block with all that moves with it.
  for (int m = 0; m < static_cast<int>(modules.size()); ++m)
    visit_rows(dofs, modules[static_cast<std::size_t>(m)],
               [&](const FieldUse& use, LocalIndex row) {
                 const RowInfo& info = dofs.info(row);
                 const int displacement = dofs.find("displacement");
                 if (displacement < 0) return;
                 const LocalIndex driven = dofs.first_row(displacement, info.kind, info.point);
                 const bool structure =
                     driven >= 0 && driven < dofs.owned() &&
                     result.governor[static_cast<std::size_t>(driven)] == Governance::kinematic;
                 for (int c = 0; c < use.components; ++c) {
                   const auto r = static_cast<std::size_t>(row + c);
                   if (result.governor[r] >= 0) result.block_of_row[r] = result.governor[r];
                   bool drives = false;
                   for (const auto& kernel : modules[static_cast<std::size_t>(m)].kernels)
                     for (const FieldUse& other : kernel->fields())
                       drives = drives || other.role == Role::kinematic;
                   if (structure && drives) result.block_of_row[r] = m;
                 }
               });
  return result;
}

}  // namespace hawser
