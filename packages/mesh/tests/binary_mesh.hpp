#pragma once
// Small meshes as binary MSH files.
#include <cstdint>
#include <sstream>
#include <string>

#include "mesh_text.hpp"

namespace hawser {

/// The mesh as gmsh writes it with Mesh.Binary = 1, format "4.1" or "2.2".
inline std::string binary(const MeshText& mesh, const std::string& version) {
  std::ostringstream out;
  const bool v4 = version == "4.1";
  const auto raw = [&](auto value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
  };
  const auto whole = [&](std::size_t value) { raw(static_cast<std::uint64_t>(value)); };
  const auto small = [&](std::size_t value) { raw(static_cast<std::int32_t>(value)); };
  const auto& groups = mesh.groups;
  out << "$MeshFormat\n" << version << " 1 8\n";
  small(1);
  out << "\n$EndMeshFormat\n$PhysicalNames\n" << groups.size() << '\n';
  for (std::size_t g = 0; g < groups.size(); ++g)
    out << groups[g].dimension << ' ' << g + 1 << " \"" << groups[g].name << "\"\n";
  out << "$EndPhysicalNames\n";
  const auto coordinates = [&](const std::array<double, 2>& node) {
    for (const double x : {node[0], node[1], 0.0})
      raw(x);
  };
  if (v4) {
    out << "$Entities\n";
    for (int d = 0; d < 4; ++d) {
      std::size_t count = 0;
      for (const auto& group : groups)
        count += group.dimension == d ? 1 : 0;
      whole(count);
    }
    for (int d = 0; d < 4; ++d)
      for (std::size_t g = 0; g < groups.size(); ++g) {
        if (groups[g].dimension != d) continue;
        small(g + 1);
        for (int k = 0; k < (d == 0 ? 3 : 6); ++k)
          raw(0.5 * k);
        whole(1);
        small(g + 1);
        if (d == 0) continue;
        whole(1);  // one bounding entity
        small(1);
      }
    out << "\n$EndEntities\n$Nodes\n";
    for (const std::size_t number :
         {std::size_t{2}, mesh.nodes.size(), std::size_t{1}, mesh.nodes.size()})
      whole(number);
    // The first node in a block with parametric coordinates, the others in one without.
    for (const bool parametric : {true, false}) {
      const std::size_t first = parametric ? 0 : 1, last = parametric ? 1 : mesh.nodes.size();
      for (const std::size_t number : {2, 1, parametric ? 1 : 0})
        small(number);
      whole(last - first);
      for (std::size_t n = first; n < last; ++n)
        whole(n + 1);
      for (std::size_t n = first; n < last; ++n) {
        coordinates(mesh.nodes[n]);
        for (int k = 0; parametric && k < 2; ++k)
          raw(0.25);
      }
    }
  } else {
    out << "$Nodes\n" << mesh.nodes.size() << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      small(n + 1);
      coordinates(mesh.nodes[n]);
    }
  }
  std::size_t count = 0, element = 0;
  for (const auto& group : groups)
    count += group.cells.size();
  out << "\n$EndNodes\n$Elements\n";
  if (v4)
    for (const std::size_t number : {groups.size(), count, std::size_t{1}, count})
      whole(number);
  else
    out << count << '\n';
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto type = static_cast<std::size_t>(groups[g].dimension == 0 ? 15 : groups[g].dimension);
    if (v4) {
      for (const std::size_t number : {static_cast<std::size_t>(groups[g].dimension), g + 1, type})
        small(number);
      whole(groups[g].cells.size());
    } else {
      for (const std::size_t number : {type, groups[g].cells.size(), std::size_t{2}})
        small(number);
    }
    for (const auto& cell : groups[g].cells) {
      v4 ? whole(++element) : small(++element);
      for (int k = 0; !v4 && k < 2; ++k)
        small(g + 1);
      for (const int v : cell)
        v4 ? whole(static_cast<std::size_t>(v) + 1) : small(static_cast<std::size_t>(v) + 1);
    }
  }
  out << "\n$EndElements\n";
  return out.str();
}

}  // namespace hawser
