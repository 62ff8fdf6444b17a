#include "src/named_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser {
namespace {

/// m, of the reference; infinite for a point.
double shortest_edge(const Mesh& mesh, const Region& region, LocalIndex cell) {
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  const auto count = static_cast<std::size_t>(region.vertices_per_cell);
  const LocalIndex* const vertices = &region.vertices[static_cast<std::size_t>(cell) * count];
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      double square = 0;
      for (std::size_t j = 0; j < dimension; ++j) {
        const double side =
            mesh.coordinates[static_cast<std::size_t>(vertices[a]) * dimension + j] -
            mesh.coordinates[static_cast<std::size_t>(vertices[b]) * dimension + j];
        square += side * side;
      }
      shortest = std::min(shortest, square);
    }
  return std::sqrt(shortest);
}

/// Per local row: of the shortest edge among the cells there.
std::vector<double> cell_sizes(const DofMap& dofs, const std::vector<KernelCells>& kernels) {
  std::vector<double> sizes(static_cast<std::size_t>(dofs.rows()),
                            std::numeric_limits<double>::infinity());
  for (const KernelCells& cells : kernels) {
    const auto n = static_cast<std::size_t>(cells.unknowns());
    for (LocalIndex cell = 0; cell < cells.region->size(); ++cell) {
      const double size = shortest_edge(dofs.mesh(), *cells.region, cell);
      for (std::size_t i = 0; i < n; ++i) {
        const LocalIndex row = cells.rows[static_cast<std::size_t>(cell) * n + i];
        if (row < 0) continue;
        double& least = sizes[static_cast<std::size_t>(row)];
        least = std::min(least, size);
      }
    }
  }
  return sizes;
}

}  // namespace

std::vector<Block> name_blocks(const DofMap& dofs, const Governance& governance,
                               const std::vector<KernelCells>& kernels) {
  const std::vector<double> sizes = cell_sizes(dofs, kernels);
  std::vector<Block> blocks;
  const auto find = [&](const std::string& name, const std::string& field) {
    return std::find_if(blocks.begin(), blocks.end(),
                        [&](const Block& b) { return b.name == name && b.field == field; });
  };
  for (const std::string& name : governance.blocks)
    for (const FieldDescription& field : dofs.fields())
      blocks.push_back({name, field.name, field.residual_unit, {}, field.has_level});
  for (LocalIndex row = 0; row < dofs.owned(); ++row) {
    const FieldDescription& field = dofs.fields()[static_cast<std::size_t>(dofs.info(row).field)];
    const int name = governance.block_of_row[static_cast<std::size_t>(row)];
    Block& block = *find(governance.blocks[static_cast<std::size_t>(name)], field.name);
    block.rows.push_back(row);
    if (field.places_nodes) block.sizes.push_back(sizes[static_cast<std::size_t>(row)]);
  }
  const Communicator& communicator = dofs.mesh().communicator;
  blocks.erase(
      std::remove_if(blocks.begin(), blocks.end(),
                     [&](const Block& block) { return !communicator.any(!block.rows.empty()); }),
      blocks.end());
  return blocks;
}

}  // namespace hawser
