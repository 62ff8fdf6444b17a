#include "src/cell_failure.hpp"

#include <sstream>

#include "hawser/base/error.hpp"

namespace hawser {

void CellFailure::throw_together(const Mesh& mesh, const State& state) const {
  mesh.communicator.together([&] {
    if (status == CellStatus::ok) return;
    if (!thrown.empty()) throw PluginError(thrown);
    if (!sentence.empty()) throw SolveError(sentence);
    const Region& region = *cells->region;
    const auto per_cell = static_cast<std::size_t>(region.vertices_per_cell);
    double centre[3] = {0, 0, 0};
    for (std::size_t v = 0; v < per_cell; ++v)
      for (int j = 0; j < mesh.dimension; ++j) {
        const LocalIndex vertex = region.vertices[static_cast<std::size_t>(cell) * per_cell + v];
        centre[j] += mesh.coordinates[static_cast<std::size_t>(vertex) *
                                          static_cast<std::size_t>(mesh.dimension) +
                                      static_cast<std::size_t>(j)] /
                     static_cast<double>(per_cell);
      }
    std::ostringstream text;
    text << "cell " << region.cell_ids[static_cast<std::size_t>(cell)] << " of region '"
         << region.name << "', which started near (" << centre[0] << ", " << centre[1];
    if (mesh.dimension == 3) text << ", " << centre[2];
    text << ") m, "
         << (status == CellStatus::inverted ? "turned inside out (det F <= 0)"
                                            : "gives a residual that is not a number")
         << (cells->stranger.empty() ? "" : " (" + cells->stranger + ")")
         << " at t = " << state.time << " s";
    throw SolveError(text.str());
  });
}

}  // namespace hawser
