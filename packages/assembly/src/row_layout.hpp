#pragma once
#include "hawser/algebra/row_layout.hpp"
#include "hawser/assembly/governance.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

/// The groups of rows that follow from who writes them: what modules add to together is one group,
/// what one governs alone is another, rows of structures' displacements follow. The largest group
/// of the first kind is solved first, then those that are governed, then the other ones. Followers,
/// places and conditions are left out. Collective.
RowLayout lay_out_rows(const DofMap& dofs, const Governance& governance);

/// Where the nodes are in `state`.
void place_rows(const DofMap& dofs, const State& state, RowLayout& layout);

}  // namespace hawser
