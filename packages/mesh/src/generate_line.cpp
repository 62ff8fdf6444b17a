// A line needs no mesher: its nodes are written as they are.
#include <fstream>

#include "hawser/base/error.hpp"
#include "hawser/mesh/generate.hpp"

namespace hawser {
namespace {

struct Point {
  const char* name;
  int node;
};

double coordinate(const LineMesh& line, int node, std::size_t axis) {
  if (!line.nodes.empty()) {
    const auto dimension = static_cast<std::size_t>(line.dimension);
    return axis < dimension ? line.nodes[dimension * static_cast<std::size_t>(node) + axis] : 0;
  }
  if (axis >= line.from.size()) return 0;
  const double share = static_cast<double>(node) / line.segments;
  return line.from[axis] + share * (line.to[axis] - line.from[axis]);
}

void write_line(std::ostream& out, const LineMesh& line) {
  const int last = line.segments + 1;
  std::vector<Point> points = {{"tow-point", 1}, {"tail", last}};
  if (line.segments % 2 == 0) points.push_back({"middle", 1 + line.segments / 2});
  out.precision(17);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << points.size() + 1;
  out << "\n1 1 \"cable\"\n";
  for (std::size_t p = 0; p < points.size(); ++p)
    out << "0 " << p + 2 << " \"" << points[p].name << "\"\n";
  out << "$EndPhysicalNames\n$Nodes\n" << last << '\n';
  for (int node = 0; node < last; ++node) {
    out << node + 1;
    for (std::size_t j = 0; j < 3; ++j)
      out << ' ' << coordinate(line, node, j);
    out << '\n';
  }
  out << "$EndNodes\n$Elements\n"
      << static_cast<std::size_t>(line.segments) + points.size() << '\n';
  for (int cell = 1; cell < last; ++cell)
    out << cell << " 1 2 1 1 " << cell << ' ' << cell + 1 << '\n';
  for (std::size_t p = 0; p < points.size(); ++p)
    out << static_cast<std::size_t>(last) + p << " 15 2 " << p + 2 << ' ' << p + 2 << ' '
        << points[p].node << '\n';
  out << "$EndElements\n";
}

}  // namespace

void generate_mesh(const Communicator& communicator, const LineMesh& line,
                   const std::string& path) {
  communicator.on_root([&] {
    std::ofstream out(path);
    write_line(out, line);
    out.close();
    if (!out) throw MeshError("the mesh cannot be written to " + path);
  });
}

}  // namespace hawser
