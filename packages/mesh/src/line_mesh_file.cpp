#include "line_mesh_file.hpp"

#include <fstream>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

void write(std::ostream& out, const LinesToWrite& lines) {
  std::size_t cells = lines.points.size(), tag = 0, group = 0;
  out.precision(17);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
      << lines.lines.size() + lines.points.size() << '\n';
  for (const auto& line : lines.lines) {
    cells += line.nodes.size() - 1;
    out << "1 " << ++group << " \"" << line.name << "\"\n";
  }
  for (const auto& point : lines.points)
    out << "0 " << ++group << " \"" << point.first << "\"\n";
  out << "$EndPhysicalNames\n$Nodes\n" << lines.nodes.size() << '\n';
  for (const auto& [x, y, z] : lines.nodes)
    out << ++tag << ' ' << x << ' ' << y << ' ' << z << '\n';
  out << "$EndNodes\n$Elements\n" << cells << '\n';
  tag = group = 0;
  for (const auto& line : lines.lines) {
    ++group;
    for (std::size_t i = 1; i < line.nodes.size(); ++i)
      out << ++tag << " 1 2 " << group << ' ' << group << ' ' << line.nodes[i - 1] + 1 << ' '
          << line.nodes[i] + 1 << '\n';
  }
  for (const auto& point : lines.points) {
    ++group;
    out << ++tag << " 15 2 " << group << ' ' << group << ' ' << point.second + 1 << '\n';
  }
  out << "$EndElements\n";
}

}  // namespace

void write_lines(const Communicator& communicator, const LinesToWrite& lines,
                 const std::string& path) {
  communicator.on_root([&] {
    std::ofstream out(path);
    write(out, lines);
    out.close();
    if (!out) throw MeshError("the mesh cannot be written to " + path);
  });
}

}  // namespace hawser
