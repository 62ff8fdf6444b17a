#pragma once
// Who may write a row. Precedence: structure kinematics over a governing module over modules that
// add; conditions come on top and are applied after assembly.
#include <string>
#include <vector>

#include "hawser/fields/dof_map.hpp"
#include "hawser/physics/kernel.hpp"

namespace hawser {

struct Governance {
  static constexpr int shared = -1;     ///< contributions of all modules add up
  static constexpr int kinematic = -2;  ///< the time scheme's relation of displacement to velocity

  std::vector<int> governor;  ///< per owned row: shared, kinematic or the index of a module
  /// Names on all ranks alike: the modules' blocks, then "interface", where modules of several add.
  std::vector<std::string> blocks;
  std::vector<int> block_of_row;  ///< per owned row
  /// Per owned row: the least of the blocks that hang together with the row's by rows to which both
  /// add, as a fluid and a structure do.
  std::vector<int> team_of_row;
  std::vector<int> team_of_block;  ///< the same per block, on all ranks alike
};

/// DeckError naming both modules when two of equal rank govern the same row. Collective.
Governance find_governors(const DofMap& dofs, const std::vector<PhysicsModule>& modules);

}  // namespace hawser
