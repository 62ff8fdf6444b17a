#pragma once
// Small meshes, written as MSH files in either format.
#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

struct MeshText {
  struct Group {
    std::string name;
    int dimension;
    std::vector<std::vector<int>> cells;  // of vertices from 0
  };
  std::vector<std::array<double, 2>> nodes;
  std::vector<Group> groups;

  /// Every group is written as one entity of its own.
  std::string in_format(const std::string& version) const {
    std::ostringstream out;
    const bool v4 = version == "4.1";
    out.precision(17);
    out << "$MeshFormat\n" << version << " 0 8\n$EndMeshFormat\n$PhysicalNames\n";
    out << groups.size() << '\n';
    for (std::size_t g = 0; g < groups.size(); ++g) {
      out << groups[g].dimension << ' ' << g + 1 << " \"" << groups[g].name << "\"\n";
    }
    out << "$EndPhysicalNames\n";
    if (v4) write_entities(out);
    out << "$Nodes\n";
    if (v4) out << "1 " << nodes.size() << " 1 " << nodes.size() << "\n2 1 0 ";
    out << nodes.size() << '\n';
    for (std::size_t n = 0; v4 && n < nodes.size(); ++n)
      out << n + 1 << '\n';
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (!v4) out << n + 1 << ' ';
      out << nodes[n][0] << ' ' << nodes[n][1] << " 0\n";
    }
    out << "$EndNodes\n$Elements\n";
    std::size_t count = 0, number = 0;
    for (const auto& group : groups)
      count += group.cells.size();
    if (v4) out << groups.size() << ' ' << count << " 1 ";
    out << count << '\n';
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const int type = groups[g].dimension == 0 ? 15 : groups[g].dimension;
      if (v4)
        out << groups[g].dimension << ' ' << g + 1 << ' ' << type << ' ' << groups[g].cells.size()
            << '\n';
      for (const auto& cell : groups[g].cells) {
        out << ++number;
        if (!v4) out << ' ' << type << " 2 " << g + 1 << ' ' << g + 1;
        for (const int v : cell)
          out << ' ' << v + 1;
        out << '\n';
      }
    }
    out << "$EndElements\n";
    return out.str();
  }

 private:
  void write_entities(std::ostream& out) const {
    out << "$Entities\n";
    std::ostringstream lines;
    for (int d = 0; d < 4; ++d) {
      int count = 0;
      for (std::size_t g = 0; g < groups.size(); ++g) {
        if (groups[g].dimension != d) continue;
        ++count;
        lines << g + 1 << (d == 0 ? " 0 0 0" : " 0 0 0 1 1 0") << " 1 " << g + 1;
        lines << (d == 0 ? "\n" : " 0\n");
      }
      out << count << (d < 3 ? ' ' : '\n');
    }
    out << lines.str() << "$EndEntities\n";
  }
};

/// nx by ny unit squares, each cut into two triangles from the lower left to the upper right;
/// vertex (i, j) is number i + (nx + 1) j. Regions "water" and "wall".
inline MeshText grid(int nx, int ny) {
  MeshText mesh;
  const auto id = [&](int i, int j) { return i + (nx + 1) * j; };
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i)
      mesh.nodes.push_back({double(i), double(j)});
  }
  MeshText::Group water{"water", 2, {}}, wall{"wall", 1, {}};
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      water.cells.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      water.cells.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  // Not in a common direction on purpose.
  for (int i = 0; i < nx; ++i)
    wall.cells.push_back({id(i, 0), id(i + 1, 0)});
  for (int i = 0; i < nx; ++i)
    wall.cells.push_back({id(i, ny), id(i + 1, ny)});
  for (int j = 0; j < ny; ++j)
    wall.cells.push_back({id(0, j), id(0, j + 1)});
  for (int j = 0; j < ny; ++j)
    wall.cells.push_back({id(nx, j), id(nx, j + 1)});
  mesh.groups = {water, wall};
  return mesh;
}

/// Over all ranks.
inline long long count_cells(const Mesh& mesh, const Domain& domain) {
  long long mine = 0;
  for (const int owner : mesh.region(domain).cell_owners)
    mine += owner == mesh.communicator.rank() ? 1 : 0;
  return mesh.communicator.sum(mine);
}

/// The lines that join the given vertices one after the other.
inline MeshText::Group line(const std::string& name, const std::vector<int>& vertices) {
  MeshText::Group group{name, 1, {}};
  for (std::size_t k = 1; k < vertices.size(); ++k) {
    group.cells.push_back({vertices[k - 1], vertices[k]});
  }
  return group;
}

/// Writes on rank 0 and reads on all; the file stays.
inline Mesh read_text(const Communicator& communicator, const std::string& text,
                      const std::vector<std::string>& slits = {},
                      const std::vector<Domain>& domains = {}) {
  if (communicator.is_root()) std::ofstream("test.msh") << text;
  MPI_Barrier(communicator.mpi());
  return read_mesh(communicator, {"test.msh", slits, 2, domains});
}

}  // namespace hawser
