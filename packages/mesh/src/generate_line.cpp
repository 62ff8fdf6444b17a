// A line needs no mesher: its nodes are written as they are.
#include "hawser/mesh/generate.hpp"
#include "line_mesh_file.hpp"

namespace hawser {

void generate_mesh(const Communicator& communicator, const LineMesh& line,
                   const std::string& path) {
  LinesToWrite file;
  file.lines.push_back({"cable", {}});
  const auto last = static_cast<std::size_t>(line.segments);
  for (std::size_t node = 0; node <= last; ++node) {
    const double share = static_cast<double>(node) / line.segments;
    auto& position = file.nodes.emplace_back();
    for (std::size_t j = 0; j < line.from.size(); ++j)
      position[j] = line.from[j] + share * (line.to[j] - line.from[j]);
    file.lines[0].nodes.push_back(node);
  }
  file.points = {{"tow-point", 0}, {"tail", last}};
  if (line.segments % 2 == 0) file.points.emplace_back("middle", last / 2);
  write_lines(communicator, file, path);
}

}  // namespace hawser
