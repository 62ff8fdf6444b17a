#include "src/cell_nodes.hpp"

namespace hawser {

void reference_nodes(const Mesh& mesh, const Region& region, LocalIndex cell, std::size_t nodes,
                     std::size_t stride, double* x) {
  const ShapeTraits& shape = traits(region.shape);
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  const auto vertices = static_cast<std::size_t>(shape.vertices);
  for (std::size_t k = 0; k < vertices; ++k) {
    const auto vertex =
        static_cast<std::size_t>(region.vertices[static_cast<std::size_t>(cell) * vertices + k]);
    for (std::size_t j = 0; j < dimension; ++j)
      x[k * stride + j] = mesh.coordinates[vertex * dimension + j];
  }
  for (std::size_t e = 0; vertices + e < nodes; ++e)
    for (std::size_t j = 0; j < dimension; ++j)
      x[(vertices + e) * stride + j] =
          0.5 * (x[static_cast<std::size_t>(shape.edge[e][0]) * stride + j] +
                 x[static_cast<std::size_t>(shape.edge[e][1]) * stride + j]);
}

void move_nodes(const std::vector<LocalIndex>& rows, const State& state, std::size_t dimension,
                std::size_t stride, double* x) {
  for (std::size_t a = 0; a < rows.size(); ++a)
    for (std::size_t j = 0; rows[a] >= 0 && j < dimension; ++j)
      x[a * stride + j] += state.value[static_cast<std::size_t>(rows[a]) + j];
}

}  // namespace hawser
