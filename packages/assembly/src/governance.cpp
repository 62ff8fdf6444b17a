#include "hawser/assembly/governance.hpp"

#include <algorithm>
#include <numeric>

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

/// `meet`: [block][block], whether this rank has a row to which both add.
void join_teams(const Communicator& communicator, const std::vector<char>& meet,
                Governance& result) {
  const std::size_t count = result.blocks.size();
  std::vector<int>& team = result.team_of_block;
  team.resize(count);
  std::iota(team.begin(), team.end(), 0);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b < count; ++b) {
      if (!communicator.any(meet[a * count + b] != 0)) continue;
      const auto [lesser, greater] = std::minmax(team[a], team[b]);
      std::replace(team.begin(), team.end(), int(greater), int(lesser));
    }
  for (int& row : result.team_of_row)
    if (row >= 0) row = team[static_cast<std::size_t>(row)];
}

// Where modules of two blocks add, small and large contributions meet: a block of its own.
void assign_blocks(const DofMap& dofs, const std::vector<PhysicsModule>& modules,
                   Governance& result) {
  const auto block = [&](const std::string& name) {
    const auto found = std::find(result.blocks.begin(), result.blocks.end(), name);
    const auto index = static_cast<int>(found - result.blocks.begin());
    if (found == result.blocks.end()) result.blocks.push_back(name);
    return index;
  };
  std::vector<int> block_of_module;
  for (const PhysicsModule& module : modules)
    block_of_module.push_back(block(module.block));
  const int interface = block("interface");
  std::vector<char> meet(result.blocks.size() * result.blocks.size(), 0);
  visit_all(dofs, modules, [&](int module, const FieldUse& use, std::size_t row) {
    const int governor = result.governor[row];
    const bool takes_part = governor == Governance::kinematic ? use.role == Role::kinematic
                                                              : governor < 0 || governor == module;
    if (!takes_part) return;
    const int mine = block_of_module[static_cast<std::size_t>(module)];
    int& chosen = result.block_of_row[row];
    chosen = chosen < 0 || chosen == mine ? mine : interface;
    int& first = result.team_of_row[row];
    if (first < 0) first = mine;
    meet[static_cast<std::size_t>(first) * result.blocks.size() + static_cast<std::size_t>(mine)] =
        1;
  });
  join_teams(dofs.mesh().communicator, meet, result);
}

}  // namespace

Governance find_governors(const DofMap& dofs, const std::vector<PhysicsModule>& modules) {
  const auto owned = static_cast<std::size_t>(dofs.owned());
  Governance result;
  result.governor.assign(owned, Governance::shared);
  result.block_of_row.assign(owned, -1);
  result.team_of_row.assign(owned, -1);
  claim_rows(dofs, modules, result);
  assign_blocks(dofs, modules, result);
  return result;
}

}  // namespace hawser
