#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "hawser/base/error.hpp"
#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

class BothFormats : public testing::TestWithParam<const char*> {
 protected:
  Mesh read(const MeshText& text) { return read_text(Communicator(), text.in_format(GetParam())); }
};
INSTANTIATE_TEST_SUITE_P(Msh, BothFormats, testing::Values("2.2", "4.1"));

TEST_P(BothFormats, CountsVerticesEdgesAndCells) {
  auto text = grid(3, 2);
  text.groups.push_back({"corner", 0, {{11}}});
  const auto mesh = read(text);
  EXPECT_EQ(mesh.vertices.global_count, 12);
  EXPECT_EQ(mesh.vertices.owned, 12);
  EXPECT_EQ(mesh.split_vertices.global_count, 12);
  EXPECT_EQ(mesh.edges.global_count, 9 + 8 + 6);
  EXPECT_EQ(mesh.region("water").size(), 12);
  EXPECT_EQ(mesh.region("wall").size(), 10);
  const auto corner = mesh.region("corner").vertices.at(0);
  EXPECT_EQ(mesh.vertices.ids[std::size_t(corner)], 11);
  EXPECT_EQ(mesh.coordinates[std::size_t(2 * corner)], 3);
  EXPECT_EQ(mesh.coordinates[std::size_t(2 * corner + 1)], 2);
}

TEST_P(BothFormats, DropsNodesOfNoCell) {
  auto text = grid(1, 1);
  text.nodes.insert(text.nodes.begin(), {7, 7});
  for (auto& group : text.groups) {
    for (auto& cell : group.cells) {
      for (auto& v : cell)
        ++v;
    }
  }
  EXPECT_EQ(read(text).vertices.global_count, 4);
}

TEST_P(BothFormats, TurnsTrianglesCounterClockwise) {
  auto text = grid(1, 1);
  std::swap(text.groups[0].cells[1][0], text.groups[0].cells[1][2]);
  const auto mesh = read(text);
  const auto& water = mesh.region("water");
  for (std::size_t c = 0; c < 2; ++c) {
    const auto x = [&](std::size_t k) {
      return &mesh.coordinates[2 * std::size_t(water.vertices[3 * c + k])];
    };
    EXPECT_NEAR(triangle_quality(x(0), x(1), x(2)), std::sqrt(3) / 2, 1e-15);
  }
}

TEST(Read, AChainOfLinesAlone) {
  MeshText text;
  for (int k = 0; k < 5; ++k)
    text.nodes.push_back({double(k), 0});
  text.groups = {line("chain", {0, 1, 2, 3, 4})};
  const auto mesh =
      read_text(Communicator(), text.in_format("4.1"), {}, {Domain::patches("chain")});
  EXPECT_EQ(mesh.vertices.global_count, 5);
  EXPECT_EQ(mesh.split_vertices.global_count, 0);
  EXPECT_FALSE(mesh.has_body());
  EXPECT_EQ(mesh.force_unit(), "N");
  EXPECT_EQ(mesh.region(Domain::patches("chain")).size(), 3);
}

TEST(Read, AnEntityOfTwoPhysicalGroupsAndSkippedSections) {
  // As gmsh writes it: a curve in two groups, one of them backwards, parametric nodes, an unknown
  // section.
  const auto mesh = read_text(Communicator(), R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
1 1 "wall"
1 2 "floor"
2 3 "water"
$EndPhysicalNames
$Entities
0 1 1 0
7 0 0 0 1 0 0 2 1 -2 0
9 0 0 0 1 1 0 1 3 1 7
$EndEntities
$Nodes
2 3 10 40
1 7 1 2
10
40
0 0 0 0
1 0 0 1
2 9 0 1
20
0 1 0
$EndNodes
$Elements
2 2 1 2
1 7 1 1
1 10 40
2 9 2 1
2 10 40 20
$EndElements
$Periodic
0
$EndPeriodic
)",
                              {}, {Domain::facets("floor")});
  EXPECT_EQ(mesh.vertices.global_count, 3);
  EXPECT_EQ(mesh.region("wall").size(), 1);
  EXPECT_EQ(mesh.region(Domain::facets("floor")).size(), 1);
}

TEST(Read, UnknownRegionNamesThoseThatAreThere) {
  const auto mesh = read_text(Communicator(), grid(1, 1).in_format("2.2"));
  EXPECT_EQ(mesh.find("cable"), nullptr);
  EXPECT_THAT(
      [&] { mesh.region("cable"); },
      testing::ThrowsMessage<MeshError>("the mesh has no region 'cable'; it has water, wall"));
}

TEST(Quality, OfKnownTriangles) {
  const double a[] = {0, 0}, b[] = {1, 0}, c[] = {0.5, std::sqrt(0.75)}, d[] = {2, 0};
  EXPECT_NEAR(triangle_quality(a, b, c), 1, 1e-15);
  EXPECT_NEAR(triangle_quality(b, a, c), -1, 1e-15);
  EXPECT_EQ(triangle_quality(a, b, d), 0);
  EXPECT_EQ(triangle_quality(a, a, a), 0);
}

}  // namespace
}  // namespace hawser
