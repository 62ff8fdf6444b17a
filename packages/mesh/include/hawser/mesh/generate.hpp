#pragma once
// Meshes made from parameters, by the program hawser_mesher: gmsh is GPL and stays out of this
// process.
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"

namespace hawser {

/// A box of water with a straight cable in it. Lengths in m.
struct TowBox {
  double x_min = 0, y_min = 0, x_max = 0, y_max = 0;
  double tow_point[2] = {0, 0};       ///< where the cable starts
  double tail[2] = {0, 0};            ///< where it ends
  double cable_size = 10;             ///< segment length on the cable
  double far_size = 500;              ///< largest size
  double growth = 0.15;               ///< of the size per distance from the cable
  double end_size = 0;                ///< segment length at the cable's ends; 0: as on the cable
  std::string flow_direction = "-y";  ///< -y, +y, -x or +x
  int refinements = 0;                ///< how often every triangle is cut into four
};

/// A box of water alone, for verification.
struct WaterBox {
  double x_min = 0, y_min = 0, x_max = 1, y_max = 1;
  double size = 0;        ///< of unstructured triangles, m
  int cells[2] = {0, 0};  ///< not 0: a grid of right triangles instead
  std::string flow_direction = "-y";
  int refinements = 0;
};

/// A straight line alone, in the plane or in space.
struct LineMesh {
  std::vector<double> from, to;  ///< 2 or 3 coordinates, m
  int segments = 1;
};

/// Region "cable", points "tow-point" (from), "tail" (to) and, with an even number of segments,
/// "middle". Collective; MeshError on all ranks.
void generate_mesh(const Communicator& communicator, const LineMesh& line, const std::string& path);

/// Regions: "water"; lines "inflow", "outflow", "sides", "left", "right", "bottom", "top"; point
/// "corner" (x_min, y_min); with a cable also the line "cable" and the points "tow-point" and
/// "tail". Returns the mesher's one line about what it made. Collective; MeshError on all ranks.
///
/// The program is looked for under the name in the environment variable HAWSER_MESHER, then beside
/// the running program, then where this library was built.
std::string generate_mesh(const Communicator& communicator, const TowBox& box,
                          const std::string& path);
std::string generate_mesh(const Communicator& communicator, const WaterBox& box,
                          const std::string& path);

}  // namespace hawser
