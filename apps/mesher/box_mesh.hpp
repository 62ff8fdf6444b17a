#pragma once
#include <array>
#include <optional>
#include <string>

#include "gmsh_session.hpp"

namespace hawser::mesher {

/// What to mesh; all lengths in m.
struct BoxOptions {
  std::array<double, 4> box{};                 ///< xmin ymin xmax ymax
  std::optional<std::array<double, 4>> cable;  ///< x0 y0 x1 y1: tow point, tail
  double cable_size = 0;                       ///< length of the segments of the cable
  double far_size = 0;              ///< largest size; without a cable the size everywhere
  double growth = 0.15;             ///< of the size per distance from the cable
  double end_size = 0;              ///< at the ends of the cable; 0: as on the cable
  std::array<int, 2> structured{};  ///< cells in x and y; 0: not structured
  int refinements = 0;              ///< how often every triangle is cut into four
  std::string flow_direction = "-y";
  std::string output;
};

/// std::invalid_argument with one sentence.
void check(const BoxOptions& options);

/// Meshes and writes MSH 4.1. std::runtime_error with one sentence.
MeshSummary mesh_box(const BoxOptions& options);

}  // namespace hawser::mesher
