#include "box_mesh.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "gmsh_session.hpp"

namespace hawser::mesher {
namespace {

enum Side { bottom, right, top, left };  // in the order of the box's curves

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void require(bool condition, const std::string& sentence) {
  if (!condition) throw std::invalid_argument(sentence);
}

double distance_to_cable(const std::array<double, 4>& cable, double x, double y) {
  const double dx = cable[2] - cable[0], dy = cable[3] - cable[1];
  const double along = ((x - cable[0]) * dx + (y - cable[1]) * dy) / (dx * dx + dy * dy);
  const double s = std::clamp(along, 0.0, 1.0);
  return std::hypot(x - cable[0] - s * dx, y - cable[1] - s * dy);
}

// The distance is exact: gmsh's own field measures it to sample points of the curve.
double size_at(const BoxOptions& o, double x, double y) {
  if (!o.cable) return o.far_size;
  const auto& c = *o.cable;
  double size = std::min(o.far_size, o.cable_size + o.growth * distance_to_cable(c, x, y));
  if (o.end_size > 0) {
    const double end = std::min(std::hypot(x - c[0], y - c[1]), std::hypot(x - c[2], y - c[3]));
    size = std::min(size, o.end_size + o.growth * end);
  }
  return size;
}

void name(int dimension, const std::vector<int>& entities, const std::string& text) {
  const int group = gmsh::model::addPhysicalGroup(dimension, entities);
  gmsh::model::setPhysicalName(dimension, group, text);
}

void name_sides(const std::vector<int>& curves, const std::string& flow_direction) {
  static const std::map<std::string, Side> outflow_of = {
      {"-y", bottom}, {"+x", right}, {"+y", top}, {"-x", left}};
  const int out = outflow_of.at(flow_direction);
  const auto curve = [&](int side) { return curves[static_cast<std::size_t>(side % 4)]; };
  name(1, {curve(out + 2)}, "inflow");
  name(1, {curve(out)}, "outflow");
  name(1, {curve(out + 1), curve(out + 3)}, "sides");
  name(1, {curve(left)}, "left");
  name(1, {curve(right)}, "right");
  name(1, {curve(bottom)}, "bottom");
  name(1, {curve(top)}, "top");
}

void build_geometry(const BoxOptions& o) {
  namespace geo = gmsh::model::geo;
  const auto [x0, y0, x1, y1] = o.box;
  const std::vector<int> corners = {geo::addPoint(x0, y0, 0), geo::addPoint(x1, y0, 0),
                                    geo::addPoint(x1, y1, 0), geo::addPoint(x0, y1, 0)};
  std::vector<int> curves;
  for (std::size_t k = 0; k < 4; ++k)
    curves.push_back(geo::addLine(corners[k], corners[(k + 1) % 4]));
  const int surface = geo::addPlaneSurface({geo::addCurveLoop(curves)});
  if (o.structured[0] > 0) {
    for (std::size_t k = 0; k < 4; ++k) {
      geo::mesh::setTransfiniteCurve(curves[k], o.structured[k % 2] + 1);
    }
    geo::mesh::setTransfiniteSurface(surface, "Left", corners);
  }
  int tow_point = 0, tail = 0, line = 0;
  if (o.cable) {
    const auto& c = *o.cable;
    tow_point = geo::addPoint(c[0], c[1], 0);
    tail = geo::addPoint(c[2], c[3], 0);
    line = geo::addLine(tow_point, tail);
    if (!(o.end_size > 0)) {
      const double length = std::hypot(c[2] - c[0], c[3] - c[1]);
      const long segments = std::max(1L, std::lround(length / o.cable_size));
      geo::mesh::setTransfiniteCurve(line, static_cast<int>(segments) + 1);
    }
  }
  geo::synchronize();
  name(2, {surface}, "water");
  name_sides(curves, o.flow_direction);
  name(0, {corners[0]}, "corner");
  if (!o.cable) return;
  gmsh::model::mesh::embed(1, {line}, 2, surface);
  name(1, {line}, "cable");
  name(0, {tow_point}, "tow-point");
  name(0, {tail}, "tail");
}

std::size_t count_segments(const std::string& group) {
  std::size_t count = 0;
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, 1);
  for (const auto& [dimension, tag] : groups) {
    std::string text;
    gmsh::model::getPhysicalName(dimension, tag, text);
    if (text != group) continue;
    std::vector<int> entities, types;
    gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, entities);
    for (const int entity : entities) {
      std::vector<std::vector<std::size_t>> elements, nodes;
      gmsh::model::mesh::getElements(types, elements, nodes, dimension, entity);
      for (const auto& some : elements)
        count += some.size();
    }
  }
  return count;
}

}  // namespace

void check(const BoxOptions& o) {
  const auto [x0, y0, x1, y1] = o.box;
  require(x0 < x1 && y0 < y1, "the box needs xmin < xmax and ymin < ymax, given " + number(x0) +
                                  " " + number(y0) + " " + number(x1) + " " + number(y1));
  const auto [nx, ny] = o.structured;
  const bool structured = nx != 0 || ny != 0;
  require(!structured || (nx > 0 && ny > 0), "a structured mesh needs at least one cell each way");
  require(!structured || !o.cable,
          "a structured mesh has no cable; leave --structured or --cable out");
  require(o.refinements >= 0 && o.refinements <= 10,
          "a mesh can be refined 0 to 10 times, given " + std::to_string(o.refinements));
  require(structured || o.far_size > 0,
          "the far size must be positive, given " + number(o.far_size));
  if (!o.cable) return;
  const auto& c = *o.cable;
  for (const std::size_t k : {0U, 2U}) {
    require(
        x0 < c[k] && c[k] < x1 && y0 < c[k + 1] && c[k + 1] < y1,
        "the cable's end (" + number(c[k]) + ", " + number(c[k + 1]) + ") is not inside the box");
  }
  const double length = std::hypot(c[2] - c[0], c[3] - c[1]);
  require(length > 0, "the cable has no length");
  require(o.cable_size > 0, "the cable size must be positive, given " + number(o.cable_size));
  require(o.cable_size <= length, "the cable size " + number(o.cable_size) +
                                      " exceeds the cable's length " + number(length));
  require(o.far_size >= o.cable_size, "the far size " + number(o.far_size) +
                                          " is smaller than the cable size " +
                                          number(o.cable_size));
  require(o.growth > 0 && o.growth <= 1,
          "the growth must lie above 0 and not above 1, given " + number(o.growth));
  require(
      o.end_size >= 0 && o.end_size <= o.cable_size,
      "the end size must not be negative nor exceed the cable size, given " + number(o.end_size));
}

MeshSummary mesh_box(const BoxOptions& options) {
  const GmshSession gmsh;
  // The size comes from the callback alone.
  gmsh::option::setNumber("Mesh.CharacteristicLengthFromPoints", 0);
  gmsh::option::setNumber("Mesh.CharacteristicLengthExtendFromBoundary", 0);
  gmsh::model::add("box");
  build_geometry(options);
  gmsh::model::mesh::setSizeCallback(
      [&](int, int, double x, double y, double) { return size_at(options, x, y); });
  gmsh::model::mesh::generate(2);
  refine_and_write(options.refinements, options.output);
  auto summary = measure();
  summary.segments = count_segments("cable");
  return summary;
}

}  // namespace hawser::mesher
