#pragma once
// Where the nodes of a cell are, in the reference mesh and moved.
#include <vector>

#include "hawser/fields/dof_map.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

/// x[node * stride + j], m, of the cell's vertices and then of the middles of its edges, which are
/// straight in the reference mesh, until there are `nodes`. What lies between is left alone.
void reference_nodes(const Mesh& mesh, const Region& region, LocalIndex cell, std::size_t nodes,
                     std::size_t stride, double* x);

/// Adds the displacement; `rows` as of DofMap::append_cell_rows, -1 where a node does not move.
void move_nodes(const std::vector<LocalIndex>& rows, const State& state, std::size_t dimension,
                std::size_t stride, double* x);

}  // namespace hawser
