#pragma once
// Lines that are joined at nodes, described in a deck: a tow from ship to tail.
//
// The segments of a line have equal lengths, its length over their number, and these are the
// unstretched ones. A line that is longer than the way between its nodes hangs in between as a
// chain of that many links under its own weight.
#include <array>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/deck/spec.hpp"

namespace hawser {

struct LineSystem {
  /// A point region.
  struct Node {
    Located<std::string> name;
    std::vector<double> at;  ///< 2 or 3 coordinates, m
    Location location;
    static Spec<Node> spec();
  };
  /// A point region within a line.
  struct Point {
    Located<std::string> name;
    Located<double> at;  ///< m, unstretched, from the line's first node
    static Spec<Point> spec();
  };
  /// A line region.
  struct Line {
    Located<std::string> name, from, to;  ///< of the line, and of its nodes
    int segments = 1;
    Located<double> length;   ///< m, unstretched; 0: the way between its nodes
    std::vector<double> sag;  ///< where it hangs when it is slack; empty: down the last coordinate
    std::vector<Point> points;
    static Spec<Line> spec();
  };
  std::vector<Node> nodes;
  std::vector<Line> lines;
  int refinements = 0;  ///< how often every segment is halved
  static Spec<LineSystem> spec();

  int segments(const Line& line) const { return line.segments << refinements; }
  int dimension() const { return static_cast<int>(nodes.front().at.size()); }
  const Node* find(const std::string& node) const;  ///< null when there is none
};

/// A chain of `links` equal links of `length` in all, at rest under its own weight between `from`
/// and `to`, which weighs along the unit vector `down`: its joints, the ends among them. 2 or 3
/// coordinates each, m. Exact for the chain, and the catenary as the links become many. The length
/// is more than the distance of the ends, of which the part across `down` is a link or more; else
/// MeshError.
std::vector<std::vector<double>> hang_chain(const std::vector<double>& from,
                                            const std::vector<double>& to, double length, int links,
                                            const std::vector<double>& down);

/// Regions by the names of lines, nodes and points. Collective; MeshError on all ranks.
void generate_mesh(const Communicator& communicator, const LineSystem& system,
                   const std::string& path);

}  // namespace hawser
