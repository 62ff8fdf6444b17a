#include "hawser/report/mesh_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/physics/field_use.hpp"

namespace hawser {
namespace {

/// The value of a nodal field; 0 where it has none.
double nodal(const DofMap& dofs, int field, LocalIndex vertex, const std::vector<double>& values,
             std::size_t j) {
  const LocalIndex first = field < 0 ? -1 : dofs.first_row(field, PointKind::vertex, vertex);
  return first < 0 ? 0.0 : values[static_cast<std::size_t>(first) + j];
}

/// x[corner][j], m.
struct MovedTriangle {
  double x[3][2];
  MovedTriangle(const DofMap& dofs, int displacement, LocalIndex cell, const State& state) {
    const Mesh& mesh = dofs.mesh();
    for (std::size_t k = 0; k < 3; ++k) {
      const LocalIndex vertex = mesh.body.vertices[3 * static_cast<std::size_t>(cell) + k];
      for (std::size_t j = 0; j < 2; ++j)
        x[k][j] = mesh.coordinates[static_cast<std::size_t>(vertex) * 2 + j] +
                  nodal(dofs, displacement, vertex, state.value, j);
    }
  }
  double quality() const { return triangle_quality(x[0], x[1], x[2]); }
};

}  // namespace

void refuse_tangled_mesh(const DofMap& dofs, const State& state) {
  const Mesh& mesh = dofs.mesh();
  const int displacement = dofs.find(field_name::displacement);
  if (displacement < 0 || !mesh.has_body()) return;
  const Region& body = mesh.body;
  mesh.communicator.together([&] {
    for (LocalIndex cell = 0; cell < body.size(); ++cell) {
      double start[2] = {0, 0};
      bool moves = true;  // as a whole; a line may move in a mesh that does not
      for (std::size_t k = 0; k < 3; ++k) {
        const LocalIndex vertex = body.vertices[3 * static_cast<std::size_t>(cell) + k];
        moves = moves && dofs.first_row(displacement, PointKind::vertex, vertex) >= 0;
        for (std::size_t j = 0; j < 2; ++j)
          start[j] += mesh.coordinates[static_cast<std::size_t>(vertex) * 2 + j] / 3;
      }
      if (!moves || MovedTriangle(dofs, displacement, cell, state).quality() > 0) continue;
      std::ostringstream text;
      text << "cell " << body.cell_ids[static_cast<std::size_t>(cell)]
           << " of the body, which started near (" << start[0] << ", " << start[1]
           << ") m, turned inside out at t = " << state.time << " s";
      throw SolveError(text.str());
    }
  });
}

MeshFigures inspect_mesh(const DofMap& dofs, const State& state) {
  const Mesh& mesh = dofs.mesh();
  const int displacement = dofs.find(field_name::displacement);
  const int velocity = dofs.find(field_name::velocity);
  MeshFigures result;
  const Region& body = mesh.body;
  for (LocalIndex cell = 0; cell < body.size(); ++cell) {
    if (body.cell_owners[static_cast<std::size_t>(cell)] != mesh.communicator.rank()) continue;
    const MovedTriangle moved(dofs, displacement, cell, state);
    const auto& x = moved.x;
    double c[2] = {0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const LocalIndex vertex = body.vertices[3 * static_cast<std::size_t>(cell) + k];
      for (std::size_t j = 0; j < 2; ++j)
        c[j] += (nodal(dofs, velocity, vertex, state.value, j) -
                 nodal(dofs, displacement, vertex, state.rate, j)) /
                3;
    }
    const double quality = moved.quality();
    result.least_quality = std::min(result.least_quality, quality);
    const double twice_area =
        (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[2][0] - x[0][0]) * (x[1][1] - x[0][1]);
    double flux = 0;  // sum of |c . grad N|, twice |c| over the cell's length along c
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      flux +=
          std::abs(c[0] * (x[a][1] - x[b][1]) + c[1] * (x[b][0] - x[a][0])) / std::abs(twice_area);
    }
    if (std::isfinite(state.step))
      result.courant = std::max(result.courant, 0.5 * flux * state.step);
  }
  const Communicator& communicator = mesh.communicator;
  result.least_quality = communicator.min(result.least_quality);
  result.courant = communicator.max(result.courant);
  return result;
}

}  // namespace hawser
