#include "graph.hpp"

#include <algorithm>
#include <numeric>

namespace hawser {
namespace {

std::size_t at(LocalIndex index) { return static_cast<std::size_t>(index); }

// Appends to `order` what can be reached from `start`, by distance, then by degree.
void visit(const Graph& graph, LocalIndex start, std::vector<char>& seen,
           std::vector<LocalIndex>& order) {
  auto head = order.size();
  order.push_back(start);
  seen[at(start)] = 1;
  for (; head < order.size(); ++head) {
    const auto v = at(order[head]);
    const auto fresh = static_cast<std::ptrdiff_t>(order.size());
    for (auto k = graph.offsets[v]; k < graph.offsets[v + 1]; ++k) {
      const auto w = graph.neighbours[at(k)];
      if (seen[at(w)]) continue;
      seen[at(w)] = 1;
      order.push_back(w);
    }
    std::stable_sort(order.begin() + fresh, order.end(),
                     [&](LocalIndex a, LocalIndex b) { return graph.degree(a) < graph.degree(b); });
  }
}

}  // namespace

LocalIndex Graph::degree(LocalIndex v) const { return offsets[at(v + 1)] - offsets[at(v)]; }

Graph make_graph(LocalIndex vertices, const std::vector<LocalIndex>& ends) {
  Graph graph;
  graph.offsets.assign(at(vertices) + 1, 0);
  for (const auto v : ends)
    ++graph.offsets[at(v) + 1];
  std::partial_sum(graph.offsets.begin(), graph.offsets.end(), graph.offsets.begin());
  auto next = graph.offsets;
  graph.neighbours.resize(ends.size());
  for (std::size_t k = 0; k < ends.size(); ++k) {
    graph.neighbours[at(next[at(ends[k])]++)] = ends[k ^ 1];
  }
  for (LocalIndex v = 0; v < vertices; ++v) {
    std::sort(graph.neighbours.begin() + graph.offsets[at(v)],
              graph.neighbours.begin() + graph.offsets[at(v) + 1]);
  }
  return graph;
}

std::vector<LocalIndex> reverse_cuthill_mckee(const Graph& graph) {
  std::vector<LocalIndex> by_degree(at(graph.size()));
  std::iota(by_degree.begin(), by_degree.end(), 0);
  std::stable_sort(by_degree.begin(), by_degree.end(),
                   [&](LocalIndex a, LocalIndex b) { return graph.degree(a) < graph.degree(b); });
  std::vector<LocalIndex> order;
  std::vector<char> seen(by_degree.size(), 0);
  for (const auto v : by_degree) {
    if (seen[at(v)]) continue;
    // A first sweep only to find a vertex at the far end: levels from there are narrow.
    const auto begin = order.size();
    visit(graph, v, seen, order);
    const auto far = order.back();
    for (auto k = begin; k < order.size(); ++k)
      seen[at(order[k])] = 0;
    order.resize(begin);
    visit(graph, far, seen, order);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

}  // namespace hawser
