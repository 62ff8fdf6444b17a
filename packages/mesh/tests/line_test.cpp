// A line alone, in the plane and in space: its regions and their numbers on any number of ranks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "hawser/mesh/generate.hpp"
#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

Mesh make_line(const LineMesh& line) {
  const Communicator all;
  generate_mesh(all, line, "line.msh");
  return read_mesh(all, {"line.msh",
                         {},
                         static_cast<int>(line.from.size()),
                         {Domain::patches("cable"), Domain::ends("cable", "tow-point"),
                          Domain::ends("cable", "middle"), Domain::ends("cable", "tail")}});
}

const double* position(const Mesh& mesh, LocalIndex vertex) {
  return &mesh.coordinates[static_cast<std::size_t>(vertex * mesh.dimension)];
}

TEST(Line, LiesInSpaceWithEqualSegments) {
  const Mesh mesh = make_line({{1, 2, 3}, {4, 6, 15}, 26});  // of length 13
  EXPECT_EQ(mesh.dimension, 3);
  EXPECT_FALSE(mesh.has_body());
  EXPECT_EQ(mesh.vertices.global_count, 27);
  const Region& cable = mesh.region("cable");
  double length = 0;
  for (LocalIndex cell = 0; cell < cable.size(); ++cell) {
    const double* const a = position(mesh, cable.vertices[static_cast<std::size_t>(2 * cell)]);
    const double* const b = position(mesh, cable.vertices[static_cast<std::size_t>(2 * cell + 1)]);
    const double segment = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    EXPECT_NEAR(segment, 0.5, 1e-14);
    if (cable.cell_owners[static_cast<std::size_t>(cell)] == mesh.communicator.rank())
      length += segment;
  }
  EXPECT_NEAR(mesh.communicator.sum(length), 13, 1e-12);
}

TEST(Line, HasPointsAtItsEndsAndInItsMiddle) {
  const Mesh mesh = make_line({{1, 2, 3}, {4, 6, 15}, 26});
  const std::map<std::string, std::array<double, 3>> expected = {
      {"tow-point", {1, 2, 3}}, {"tail", {4, 6, 15}}, {"middle", {2.5, 4, 9}}};
  for (const auto& [name, place] : expected) {
    const Region& point = mesh.region(name);
    EXPECT_EQ(mesh.communicator.sum(static_cast<long long>(point.cell_ids.empty() ? 0 : 1)) > 0,
              true);
    for (const LocalIndex vertex : point.vertices)
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_NEAR(position(mesh, vertex)[j], place[j], 1e-14) << name;
  }
  EXPECT_EQ(make_line({{0, 0}, {1, 0}, 3}).find("middle"), nullptr);
}

TEST(Line, HasPatchesAroundInnerNodesAndCellsThatBeginAtPoints) {
  const Mesh mesh = make_line({{0, 0}, {8, 0}, 4});
  EXPECT_EQ(count_cells(mesh, Domain::patches("cable")), 3);
  EXPECT_EQ(count_cells(mesh, Domain::ends("cable", "tow-point")), 1);
  EXPECT_EQ(count_cells(mesh, Domain::ends("cable", "middle")), 2);
  const Region& tail = mesh.region(Domain::ends("cable", "tail"));
  for (LocalIndex cell = 0; cell < tail.size(); ++cell) {
    EXPECT_EQ(position(mesh, tail.vertices[static_cast<std::size_t>(2 * cell)])[0], 8);
    EXPECT_EQ(position(mesh, tail.vertices[static_cast<std::size_t>(2 * cell + 1)])[0], 6);
  }
}

TEST(Line, IsLaidAlongACurveInSegmentsOfItsOwnLength) {
  // A right angle: chords of 1 cut the corner, and the cable of 4 ends beyond 1.5 + 2.6 of curve.
  std::vector<double> nodes;
  EXPECT_EQ(lay_line({{0, 0, 0}, {1.5, 0, 0}, {1.5, 2.6, 0}}, 2, 4, 4, nodes), "");
  ASSERT_EQ(nodes.size(), 10U);
  for (std::size_t i = 2; i < nodes.size(); i += 2)
    EXPECT_NEAR(std::hypot(nodes[i] - nodes[i - 2], nodes[i + 1] - nodes[i - 1]), 1, 1e-14);
  EXPECT_DOUBLE_EQ(nodes[4], 1.5);
  EXPECT_NEAR(nodes[5], std::sqrt(0.75), 1e-14);
  EXPECT_EQ(nodes[8], 1.5);
}

TEST(Line, RefusesAShapeThatIsTooShortOrTooLong) {
  std::vector<double> nodes;
  EXPECT_THAT(
      lay_line({{0, 0, 0}, {10, 0, 0}}, 2, 12, 6, nodes),
      testing::HasSubstr("the shape is 10 m long, and the cable 12 m: 2 m of it have no place"));
  EXPECT_THAT(lay_line({{0, 0, 0}, {10, 0, 0}}, 2, 9, 3, nodes),
              testing::HasSubstr("it would be stretched"));
}

}  // namespace
}  // namespace hawser
