#include "line_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>

#include "whole_mesh.hpp"

namespace hawser {

double edge_length(const Mesh& mesh, LocalIndex edge) {
  const auto a = mesh.edge_ends[at(2 * edge)], b = mesh.edge_ends[at(2 * edge + 1)];
  double squared = 0;
  for (int j = 0; j < mesh.dimension; ++j) {
    const double way =
        mesh.coordinates[at(mesh.dimension * b + j)] - mesh.coordinates[at(mesh.dimension * a + j)];
    squared += way * way;
  }
  return std::sqrt(squared);
}

std::vector<LinePiece> line_pieces(const Mesh& mesh, const std::vector<LocalIndex>& edges) {
  std::vector<LocalIndex> vertices;
  for (const auto e : edges)
    vertices.insert(vertices.end(), {mesh.edge_ends[at(2 * e)], mesh.edge_ends[at(2 * e + 1)]});
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto place = [&](LocalIndex v) {
    return static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                                    vertices.begin());
  };
  std::vector<std::size_t> parent(vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::size_t i) {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<int> edges_at(vertices.size(), 0);
  for (const auto e : edges) {
    const auto a = place(mesh.edge_ends[at(2 * e)]), b = place(mesh.edge_ends[at(2 * e + 1)]);
    ++edges_at[a];
    ++edges_at[b];
    const auto c = root(a), d = root(b);
    parent[std::max(c, d)] = std::min(c, d);
  }
  std::map<std::size_t, LinePiece> pieces;  // by root, the lowest vertex
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    auto& piece = pieces[root(i)];
    if (root(i) == i) piece.first = vertices[i];
    if (edges_at[i] == 1) piece.ends.push_back(vertices[i]);
  }
  for (const auto e : edges) {
    auto& piece = pieces[root(place(mesh.edge_ends[at(2 * e)]))];
    ++piece.edges;
    piece.length += edge_length(mesh, e);
  }
  std::vector<LinePiece> result;
  for (auto& [first, piece] : pieces)
    result.push_back(std::move(piece));
  return result;
}

std::string describe_pieces(const Mesh& mesh, const std::vector<LinePiece>& pieces) {
  constexpr std::size_t most = 3;
  std::ostringstream text;
  for (std::size_t i = 0; i < std::min(most, pieces.size()); ++i) {
    const auto& piece = pieces[i];
    text << (i == 0 ? "" : "; ");
    if (piece.ends.empty())
      text << "a ring through " << position_text(mesh, piece.first);
    else
      text << "from " << position_text(mesh, piece.ends.front()) << " to "
           << position_text(mesh, piece.ends.back());
    text << ", " << piece.length << " m";
  }
  if (pieces.size() > most) text << "; and " << pieces.size() - most << " more pieces";
  return text.str();
}

}  // namespace hawser
