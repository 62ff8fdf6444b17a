#pragma once
// Meshes made from parameters, by the program hawser_mesher: gmsh is GPL and stays out of this
// process.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/deck/spec.hpp"

namespace hawser {

/// A box of water with a straight cable in it. Places are pairs of coordinates; lengths in m.
struct TowBox {
  std::vector<double> min, max;            ///< lower left and upper right corner
  std::vector<double> tow_point = {0, 0};  ///< where the cable starts
  std::vector<double> tail;                ///< where it ends
  double cable_size = 10;                  ///< segment length on the cable
  double far_size = 500;                   ///< largest size
  double growth = 0.15;                    ///< of the size per distance from the cable
  double end_size = 0;                     ///< segment length at the cable's ends; 0: as elsewhere
  std::string flow_direction = "-y";       ///< -y, +y, -x or +x
  int refinements = 0;                     ///< how often every triangle is cut into four
  static Spec<TowBox> spec();
};

/// A box of water alone.
struct WaterBox {
  std::vector<double> min, max;
  double size = 0;                     ///< of unstructured triangles, m
  std::vector<double> cells = {0, 0};  ///< not 0: a grid of right triangles instead
  std::string flow_direction = "-y";
  int refinements = 0;
  static Spec<WaterBox> spec();
};

/// A line alone, in the plane or in space: straight, or laid along a curve.
struct LineMesh {
  std::vector<double> from, to;  ///< 2 or 3 coordinates, m
  int segments = 1;
  Located<std::string> shape = {};          ///< file of the curve; empty: straight
  std::optional<double> cable_length = {};  ///< m, of a line along a curve; none: the curve's
  /// m, [node][2 or 3] of a line along a curve, which whoever can read the file fills.
  std::vector<double> nodes = {};
  int dimension = 0;  ///< of the nodes
  static Spec<LineMesh> spec();
};

/// Nodes [node][dimension] along the polyline `points`, from its first point on, each as far from
/// the one before as the segments are long: a cable of `length`, laid out without strain. The last
/// one lies straight on where the curve ends less than half a segment early. Sets `nodes` and
/// returns "", or says why it cannot be.
std::string lay_line(const std::vector<std::array<double, 3>>& points, int dimension, double length,
                     int segments, std::vector<double>& nodes);

/// A geometry in gmsh's own language, meshed in the plane.
struct GeoMesh {
  struct Number {
    std::string name;
    double value = 0;
    static Spec<Number> spec();
  };
  Located<std::string> file;
  std::vector<Number> numbers;  ///< in place of those that the file has by DefineConstant
  int refinements = 0;          ///< how often every cell is cut into four
  static Spec<GeoMesh> spec();
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

/// `file`: where geo.file lies. Physical groups are those of the file.
std::string generate_mesh(const Communicator& communicator, const GeoMesh& geo,
                          const std::string& file, const std::string& path);

}  // namespace hawser
