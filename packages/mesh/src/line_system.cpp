// <lines> of a deck, what of it does not fit together, and its mesh.
#include "hawser/mesh/line_system.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "hawser/base/error.hpp"
#include "line_mesh_file.hpp"

namespace hawser {
namespace {

// Shares of a length that decks' formulas may be off by.
constexpr double round_off = 1e-9;

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double squared = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    squared += (b[j] - a[j]) * (b[j] - a[j]);
  return std::sqrt(squared);
}

/// A unit vector.
std::vector<double> down_of(const LineSystem::Line& line, std::size_t dimension) {
  std::vector<double> down = line.sag;
  if (down.empty()) {
    down.assign(dimension, 0);
    down.back() = -1;
  }
  const double size = distance(std::vector<double>(dimension, 0), down);
  for (double& component : down)
    component /= size;
  return down;
}

bool is_slack(double length, double way) { return length > way * (1 + round_off); }

std::string metres(double length) { return write_value(std::round(length * 1e6) / 1e6) + " m"; }

class Check {
 public:
  Check(const LineSystem& system, Diagnostics& diagnostics)
      : system_(system), diagnostics_(diagnostics) {}

  void all() {
    look_at_nodes();
    for (const auto& line : system_.lines)
      look_at(line);
    for (const auto& node : system_.nodes)
      if (std::none_of(system_.lines.begin(), system_.lines.end(), [&](const auto& line) {
            return *line.from == *node.name || *line.to == *node.name;
          }))
        diagnostics_.error(node.name.location,
                           "no line begins or ends at the node '" + *node.name + "'");
  }

 private:
  void take_name(const Located<std::string>& name) {
    constexpr auto allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
    if (name->empty() || name->find_first_not_of(allowed) != std::string::npos)
      diagnostics_.error(name.location, quoted(*name) +
                                            " cannot be the name of a region; letters, digits, "
                                            "'-', '_' and '.' are allowed");
    const auto [known, is_new] = places_.emplace(*name, name.location);
    if (!is_new)
      diagnostics_.error(name.location, "the name '" + *name + "' is taken, at " +
                                            known->second.text() +
                                            "; lines, nodes and points are regions, and each needs "
                                            "a name of its own");
  }

  void look_at_nodes() {
    for (const auto& node : system_.nodes) {
      take_name(node.name);
      names_.push_back(*node.name);
      if (node.at.size() != system_.nodes.front().at.size())
        diagnostics_.error(node.location,
                           "node '" + *node.name + "' has " + std::to_string(node.at.size()) +
                               " coordinates, and node '" + *system_.nodes.front().name + "' " +
                               std::to_string(system_.nodes.front().at.size()));
    }
  }

  const LineSystem::Node* node_of(const Located<std::string>& name) {
    const auto* const node = system_.find(*name);
    if (node == nullptr)
      diagnostics_.error(name.location, "there is no node '" + *name + "'; there are " +
                                            listed(names_) + did_you_mean(*name, names_));
    return node;
  }

  void look_at(const LineSystem::Line& line) {
    take_name(line.name);
    for (const auto& point : line.points)
      take_name(point.name);
    const auto* const from = node_of(line.from);
    const auto* const to = node_of(line.to);
    if (from == nullptr || to == nullptr || from->at.size() != to->at.size()) return;
    const double way = distance(from->at, to->at);
    const std::string ends = "'" + *line.from + "' and '" + *line.to + "'";
    const auto fault = [&](const Location& where, const std::string& sentence) {
      diagnostics_.error(where, "line '" + *line.name + "': " + sentence);
    };
    if (way == 0) return fault(line.from.location, "its nodes " + ends + " are the same point");
    if (*line.length > 0 && *line.length < way * (1 - round_off))
      return fault(line.length.location, "its length of " + metres(line.length) +
                                             " is less than the " + metres(way) + " between " +
                                             ends +
                                             "; lengths are unstretched, and a mesh holds "
                                             "no stretched line: move a node");
    if (is_slack(line.length, way)) look_at_slack(line, *from, *to, fault);
    look_at_points(line, *line.length > 0 ? *line.length : way);
  }

  template <class Fault>
  void look_at_slack(const LineSystem::Line& line, const LineSystem::Node& from,
                     const LineSystem::Node& to, const Fault& fault) {
    const std::size_t dimension = from.at.size();
    if (line.segments < 2)
      return fault(line.length.location,
                   "one segment cannot be longer than the way between its ends; it needs more");
    if (!line.sag.empty() && line.sag.size() != dimension)
      return fault(line.name.location, "'sag' has " + std::to_string(line.sag.size()) +
                                           " components, and its nodes " +
                                           std::to_string(dimension));
    if (std::all_of(line.sag.begin(), line.sag.end(), [](double s) { return s == 0; }) &&
        !line.sag.empty())
      return fault(line.name.location, "'sag' is no direction");
    const auto down = down_of(line, dimension);
    double drop = 0;
    for (std::size_t j = 0; j < dimension; ++j)
      drop += (to.at[j] - from.at[j]) * down[j];
    const double way = distance(from.at, to.at);
    if (std::sqrt(std::max(0.0, way * way - drop * drop)) < *line.length / line.segments)
      fault(line.length.location,
            "it is longer than the way between its nodes, of which one is below the other to less "
            "than a segment's length: it would hang doubled, with a kink; move a node aside, give "
            "another 'sag', or more segments");
  }

  void look_at_points(const LineSystem::Line& line, double length) {
    const double segment = length / line.segments;
    for (const auto& point : line.points) {
      const double place = *point.at / segment, nearest = std::round(place);
      const std::string who = "point '" + *point.name + "' of line '" + *line.name + "'";
      if (nearest < 1 || nearest > line.segments - 1)
        diagnostics_.error(point.at.location,
                           who + " is not within the line, which goes from 0 to " + metres(length) +
                               (nearest == 0 || nearest == line.segments
                                    ? "; its ends have names: those of its nodes"
                                    : ""));
      else if (std::abs(place - nearest) > 1e3 * round_off * line.segments)
        diagnostics_.error(point.at.location,
                           who + " is no end of a segment, which are " + metres(segment) +
                               " long; the nearest one is at " + metres(nearest * segment));
    }
  }

  const LineSystem& system_;
  Diagnostics& diagnostics_;
  std::map<std::string, Location> places_;
  std::vector<std::string> names_;  // of nodes
};

std::array<double, 3> in_space(const std::vector<double>& position) {
  std::array<double, 3> result{};
  std::copy(position.begin(), position.end(), result.begin());
  return result;
}

/// The ends of its segments.
std::vector<std::vector<double>> positions(const LineSystem::Line& line,
                                           const std::vector<double>& from,
                                           const std::vector<double>& to, int segments) {
  if (is_slack(line.length, distance(from, to)))
    return hang_chain(from, to, line.length, segments, down_of(line, from.size()));
  std::vector<std::vector<double>> result;
  for (int i = 0; i <= segments; ++i) {
    const double share = static_cast<double>(i) / segments;
    result.push_back(from);
    for (std::size_t j = 0; j < from.size(); ++j)
      result.back()[j] += share * (to[j] - from[j]);
  }
  return result;
}

}  // namespace

const LineSystem::Node* LineSystem::find(const std::string& node) const {
  for (const Node& known : nodes)
    if (*known.name == node) return &known;
  return nullptr;
}

Spec<LineSystem::Node> LineSystem::Node::spec() {
  using P = Node;
  return Spec<P>("node", "A point region, where lines begin and end.")
      .attribute("name", &P::name, required(), "Of the region.")
      .attribute("at", &P::at, "m", required() && any() && length(2, 3), "Where it is at first.")
      .location(&P::location);
}

Spec<LineSystem::Point> LineSystem::Point::spec() {
  using P = Point;
  return Spec<P>("point", "A point region within a line, at an end of one of its segments.")
      .attribute("name", &P::name, required(), "Of the region.")
      .attribute("at", &P::at, "m", required() && positive(),
                 "Unstretched length from the line's first node.");
}

Spec<LineSystem::Line> LineSystem::Line::spec() {
  using P = Line;
  return Spec<P>("line", "A line region from node to node.")
      .attribute("name", &P::name, required(), "Of the region.")
      .attribute("from", &P::from, required(), "The node where it begins, by name.")
      .attribute("to", &P::to, required(), "The node where it ends, by name.")
      .attribute("segments", &P::segments, required() && at_least(1), "Of equal length.")
      .attribute("length", &P::length, "m", non_negative(),
                 "Unstretched; 0 for the way between its nodes. A longer line hangs in between as "
                 "a chain of its segments under its own weight.")
      .attribute("sag", &P::sag, "1",
                 any() && hawser::length(2, 3) && absent("down the last coordinate"),
                 "Where to a line hangs that is longer than the way between its nodes.")
      .children(&P::points);
}

Spec<LineSystem> LineSystem::spec() {
  using P = LineSystem;
  return Spec<P>("lines",
                 "Lines joined at nodes, in the plane or in space: each line is a region, and so "
                 "is each node.")
      .source("doc/survey.md, \"Lines and nodes\"")
      .attribute("refinements", &P::refinements, between(0, 10),
                 "How often every segment so described is halved.")
      .children(&P::nodes, required())
      .children(&P::lines, required())
      .check([](const P& p, const Location&, Diagnostics& diagnostics) {
        Check(p, diagnostics).all();
      });
}

void generate_mesh(const Communicator& communicator, const LineSystem& system,
                   const std::string& path) {
  LinesToWrite file;
  std::map<std::string, std::size_t> number;
  for (const auto& node : system.nodes) {
    number[*node.name] = file.nodes.size();
    file.points.emplace_back(*node.name, file.nodes.size());
    file.nodes.push_back(in_space(node.at));
  }
  for (const auto& line : system.lines) {
    const auto ends = positions(line, system.find(*line.from)->at, system.find(*line.to)->at,
                                system.segments(line));
    auto& written = file.lines.emplace_back();
    written.name = *line.name;
    written.nodes.push_back(number[*line.from]);
    for (std::size_t i = 1; i + 1 < ends.size(); ++i) {
      written.nodes.push_back(file.nodes.size());
      file.nodes.push_back(in_space(ends[i]));
    }
    written.nodes.push_back(number[*line.to]);
    const double way = distance(ends.front(), ends.back());
    const double segment = std::max(*line.length, way) / system.segments(line);
    for (const auto& point : line.points)
      file.points.emplace_back(
          *point.name, written.nodes[static_cast<std::size_t>(std::lround(*point.at / segment))]);
  }
  write_lines(communicator, file, path);
}

}  // namespace hawser
