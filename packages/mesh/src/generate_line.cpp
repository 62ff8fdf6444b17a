// A line needs no mesher: its nodes are written as they are.
#include <algorithm>

#include "hawser/mesh/generate.hpp"
#include "line_mesh_file.hpp"

namespace hawser {
namespace {

std::array<double, 3> position(const LineMesh& line, std::size_t node) {
  std::array<double, 3> place{};
  if (!line.nodes.empty()) {
    const auto first = line.nodes.begin() + static_cast<std::ptrdiff_t>(node) * line.dimension;
    std::copy(first, first + line.dimension, place.begin());
    return place;
  }
  const double share = static_cast<double>(node) / line.segments;
  for (std::size_t j = 0; j < line.from.size(); ++j)
    place[j] = line.from[j] + share * (line.to[j] - line.from[j]);
  return place;
}

}  // namespace

void generate_mesh(const Communicator& communicator, const LineMesh& line,
                   const std::string& path) {
  LinesToWrite file;
  file.lines.push_back({"cable", {}});
  const auto last = static_cast<std::size_t>(line.segments);
  for (std::size_t node = 0; node <= last; ++node) {
    file.nodes.push_back(position(line, node));
    file.lines[0].nodes.push_back(node);
  }
  file.points = {{"tow-point", 0}, {"tail", last}};
  if (line.segments % 2 == 0) file.points.emplace_back("middle", last / 2);
  write_lines(communicator, file, path);
}

}  // namespace hawser
