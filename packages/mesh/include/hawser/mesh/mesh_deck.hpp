#pragma once
// What a deck says of the mesh.
#include <optional>
#include <string>
#include <vector>

#include "hawser/mesh/generate.hpp"
#include "hawser/mesh/line_system.hpp"

namespace hawser {

struct MeshFileDeck {
  Located<std::string> name;
  int dimension = 2;  ///< of the space
  static Spec<MeshFileDeck> spec();
};

struct MeshDeck {
  std::vector<std::string> slits, apart;
  bool open_boundary = false;
  // Exactly one of these says where the mesh comes from.
  std::optional<TowBox> tow_box;
  std::optional<WaterBox> water_box;
  std::optional<LineMesh> line;
  std::optional<LineSystem> lines;
  std::optional<MeshFileDeck> file;
  std::optional<GeoMesh> geo;
  Location location;
  static Spec<MeshDeck> spec();
  int dimension() const;  ///< of the space; known before there is a mesh
  /// Makes the mesh, unless it is a file, at `path`; returns one line about it. `geometry`: where
  /// the file of <geo> lies. Collective.
  std::string generate(const Communicator& communicator, const std::string& geometry,
                       const std::string& path) const;
};

}  // namespace hawser
