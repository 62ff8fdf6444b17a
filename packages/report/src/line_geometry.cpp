#include "hawser/report/line_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "hawser/base/error.hpp"
#include "hawser/physics/field_use.hpp"

namespace hawser {
namespace {

std::vector<GlobalIndex> gather_all(const Communicator& communicator,
                                    const std::vector<GlobalIndex>& mine) {
  std::vector<int> counts(static_cast<std::size_t>(communicator.size()));
  const int count = static_cast<int>(mine.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator.mpi());
  std::vector<int> starts(counts.size(), 0);
  for (std::size_t r = 1; r < counts.size(); ++r)
    starts[r] = starts[r - 1] + counts[r - 1];
  std::vector<GlobalIndex> all(static_cast<std::size_t>(starts.back() + counts.back()));
  MPI_Allgatherv(mine.data(), count, MPI_LONG_LONG, all.data(), counts.data(), starts.data(),
                 MPI_LONG_LONG, communicator.mpi());
  return all;
}

}  // namespace

LineGeometry::LineGeometry(const DofMap& dofs, const Region& line, const Region& start)
    : dofs_(dofs), line_(line) {
  const Mesh& mesh = dofs.mesh();
  const auto id = [&](LocalIndex vertex) {
    return mesh.vertices.ids[static_cast<std::size_t>(vertex)];
  };
  std::vector<GlobalIndex> ends;
  for (LocalIndex cell = 0; cell < line.size(); ++cell)
    if (line.cell_owners[static_cast<std::size_t>(cell)] == mesh.communicator.rank())
      for (std::size_t k = 0; k < 2; ++k)
        ends.push_back(id(line.vertices[2 * static_cast<std::size_t>(cell) + k]));
  ends = gather_all(mesh.communicator, ends);
  std::vector<GlobalIndex> starts;
  for (const LocalIndex vertex : start.vertices)
    starts.push_back(id(vertex));
  starts = gather_all(mesh.communicator, starts);

  std::multimap<GlobalIndex, GlobalIndex> neighbours;
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    neighbours.emplace(ends[k], ends[k + 1]);
    neighbours.emplace(ends[k + 1], ends[k]);
  }
  const std::size_t expected = ends.size() / 2 + 1;
  GlobalIndex previous = -1;
  GlobalIndex current = starts.empty() ? -1 : starts.front();
  while (neighbours.count(current) > 0 && ids_.size() < expected) {
    ids_.push_back(current);
    GlobalIndex next = -1;
    const auto range = neighbours.equal_range(current);
    for (auto it = range.first; it != range.second; ++it)
      if (it->second != previous) next = it->second;
    previous = current;
    current = next;
  }
  std::map<GlobalIndex, std::size_t> place;
  for (std::size_t i = 0; i < ids_.size(); ++i)
    place.emplace(ids_[i], i);
  // Round a ring the walk comes to its first node again.
  if (place.size() != expected)
    throw MeshError("region '" + line.name + "' is not one unbranched line that starts at '" +
                    start.name + "'");

  for (LocalIndex vertex = 0; vertex < mesh.vertices.owned; ++vertex) {
    const auto found = place.find(id(vertex));
    if (found != place.end()) owned_.push_back({vertex, found->second});
  }
  for (std::size_t cell = 0; cell < line.cell_ids.size(); ++cell)
    segment_of_cell_.push_back(
        std::min(place.at(id(line.vertices[2 * cell])), place.at(id(line.vertices[2 * cell + 1]))));
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  reference_.assign(ids_.size() * dimension, 0);
  for (const OwnedNode& node : owned_)
    for (std::size_t j = 0; j < dimension; ++j)
      reference_[node.place * dimension + j] =
          mesh.coordinates[static_cast<std::size_t>(node.vertex) * dimension + j];
  MPI_Allreduce(MPI_IN_PLACE, reference_.data(), static_cast<int>(reference_.size()), MPI_DOUBLE,
                MPI_SUM, mesh.communicator.mpi());
  arc_length_.push_back(0);
  for (std::size_t i = 1; i < ids_.size(); ++i) {
    double squared = 0;
    for (std::size_t j = 0; j < dimension; ++j)
      squared += std::pow(reference_[i * dimension + j] - reference_[(i - 1) * dimension + j], 2);
    arc_length_.push_back(arc_length_.back() + std::sqrt(squared));
  }
}

std::vector<double> LineGeometry::gather(const std::string& field, const State& state) const {
  const auto dimension = static_cast<std::size_t>(dofs_.mesh().dimension);
  std::vector<double> result(ids_.size() * dimension, 0);
  const int index = dofs_.find(field);
  if (index >= 0)
    for (const OwnedNode& node : owned_) {
      const LocalIndex first = dofs_.first_row(index, PointKind::vertex, node.vertex);
      for (std::size_t j = 0; first >= 0 && j < dimension; ++j)
        result[node.place * dimension + j] = state.value[static_cast<std::size_t>(first) + j];
    }
  MPI_Allreduce(MPI_IN_PLACE, result.data(), static_cast<int>(result.size()), MPI_DOUBLE, MPI_SUM,
                dofs_.mesh().communicator.mpi());
  return result;
}

std::vector<double> LineGeometry::gather_cells(const std::vector<double>& values) const {
  std::vector<double> result(ids_.size() - 1, 0);
  const Communicator& communicator = dofs_.mesh().communicator;
  for (std::size_t cell = 0; cell < values.size(); ++cell)
    if (line_.cell_owners[cell] == communicator.rank())
      result[segment_of_cell_[cell]] = values[cell];
  MPI_Allreduce(MPI_IN_PLACE, result.data(), static_cast<int>(result.size()), MPI_DOUBLE, MPI_SUM,
                communicator.mpi());
  return result;
}

std::vector<double> LineGeometry::positions(const State& state) const {
  std::vector<double> result = gather(field_name::displacement, state);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] += reference_[i];
  return result;
}

}  // namespace hawser
