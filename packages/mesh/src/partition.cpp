#include <metis.h>

#include <set>
#include <stdexcept>

#include "graph.hpp"

namespace hawser {
namespace {

std::vector<int> slices(LocalIndex vertices, int parts) {
  std::vector<int> result(static_cast<std::size_t>(vertices));
  for (std::size_t v = 0; v < result.size(); ++v) {
    result[v] = static_cast<int>(v * static_cast<std::size_t>(parts) / result.size());
  }
  return result;
}

bool every_part_occurs(const std::vector<int>& part_of, int parts) {
  return std::set<int>(part_of.begin(), part_of.end()).size() == static_cast<std::size_t>(parts);
}

std::vector<int> metis(const Graph& graph, int parts) {
  std::vector<idx_t> offsets(graph.offsets.begin(), graph.offsets.end());
  std::vector<idx_t> neighbours(graph.neighbours.begin(), graph.neighbours.end());
  std::vector<idx_t> part_of(static_cast<std::size_t>(graph.size()));
  idx_t vertices = graph.size(), constraints = 1, count = parts, cut = 0;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  const int status = METIS_PartGraphKway(&vertices, &constraints, offsets.data(), neighbours.data(),
                                         nullptr, nullptr, nullptr, &count, nullptr, nullptr,
                                         options, &cut, part_of.data());
  if (status != METIS_OK) throw std::logic_error("METIS_PartGraphKway refused a vertex graph");
  return {part_of.begin(), part_of.end()};
}

}  // namespace

std::vector<int> partition(const Graph& graph, int parts) {
  // METIS dies of a division by zero for one part, and leaves parts empty when vertices are few.
  constexpr int few = 8;
  if (parts == 1 || graph.size() < few * parts || graph.neighbours.empty()) {
    return slices(graph.size(), parts);
  }
  auto result = metis(graph, parts);
  return every_part_occurs(result, parts) ? result : slices(graph.size(), parts);
}

}  // namespace hawser
