#include "audit_findings.hpp"

#include <algorithm>

#include "line_pieces.hpp"
#include "whole_mesh.hpp"

namespace hawser {

std::string in_quotes(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names)
    text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

std::string Findings::places(const std::vector<LocalIndex>& vertices) const {
  constexpr std::size_t most = 3;
  std::string text = "at ";
  for (std::size_t i = 0; i < std::min(most, vertices.size()); ++i)
    text += (i == 0 ? "" : ", ") + position_text(mesh_, vertices[i]);
  if (vertices.size() > most) text += " and " + std::to_string(vertices.size() - most) + " more";
  return text;
}

std::string Findings::places_of_cells(const std::vector<LocalIndex>& cells) const {
  std::vector<LocalIndex> first_corners;
  for (const auto cell : cells)
    first_corners.push_back(mesh_.body.vertices[at(cell * mesh_.body.vertices_per_cell)]);
  return places(first_corners);
}

std::string Findings::pieces(const std::vector<LocalIndex>& edges) const {
  return describe_pieces(mesh_, line_pieces(mesh_, edges));
}

std::string Findings::regions_at(const std::vector<LocalIndex>& vertices) const {
  std::vector<char> wanted(mesh_.vertices.ids.size(), 0);
  for (const auto v : vertices)
    wanted[at(v)] = 1;
  std::vector<std::string> names;
  for (const auto& region : mesh_.regions)
    if (std::any_of(region.vertices.begin(), region.vertices.end(),
                    [&](LocalIndex v) { return wanted[at(v)] != 0; }))
      names.push_back(region.name);
  return in_quotes(names);
}

}  // namespace hawser
