// Sides of slits on a 4 by 4 grid; vertex (i, j) is number i + 5 j.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

int at(int i, int j) { return i + 5 * j; }

Mesh with_cable(const MeshText::Group& cable) {
  auto text = grid(4, 4);
  text.groups.push_back(cable);
  return read_text(Communicator(), text.in_format("4.1"), {"cable"});
}

// Over all ranks, how many split vertices each vertex has; those with one are left out.
std::map<int, int> doubled(const Mesh& mesh) {
  std::vector<int> count(std::size_t(mesh.vertices.global_count), 0);
  for (LocalIndex s = 0; s < mesh.split_vertices.owned; ++s) {
    const auto vertex = mesh.vertex_of_split[std::size_t(s)];
    ++count[std::size_t(mesh.vertices.ids[std::size_t(vertex)])];
  }
  MPI_Allreduce(MPI_IN_PLACE, count.data(), int(count.size()), MPI_INT, MPI_SUM,
                mesh.communicator.mpi());
  std::map<int, int> result;
  for (std::size_t v = 0; v < count.size(); ++v) {
    if (count[v] != 1) result[int(v)] = count[v];
  }
  return result;
}

TEST(Sides, NoSlitMeansOneSplitVertexPerVertex) {
  const auto mesh = read_text(Communicator(), grid(4, 4).in_format("4.1"));
  EXPECT_EQ(mesh.split_vertices.ids, mesh.vertices.ids);
  EXPECT_EQ(mesh.region("water").split_vertices, mesh.region("water").vertices);
}

TEST(Sides, TipsAreSingleAndTheInsideDouble) {
  const auto mesh = with_cable(line("cable", {at(1, 2), at(2, 2), at(3, 2)}));
  EXPECT_EQ(mesh.split_vertices.global_count, 26);
  EXPECT_EQ(doubled(mesh), (std::map<int, int>{{at(2, 2), 2}}));
}

// Also the triangles that touch the line at this one vertex.
TEST(Sides, EveryTriangleKnowsItsSide) {
  const auto mesh = with_cable(line("cable", {at(1, 2), at(2, 2), at(3, 2)}));
  const auto& water = mesh.region("water");
  std::set<GlobalIndex> above, below;
  int corners = 0;
  for (std::size_t k = 0; k < water.vertices.size(); ++k) {
    if (mesh.vertices.ids[std::size_t(water.vertices[k])] != at(2, 2)) continue;
    double y = 0;
    for (std::size_t c = k / 3 * 3; c < k / 3 * 3 + 3; ++c) {
      y += mesh.coordinates[2 * std::size_t(water.vertices[c]) + 1] / 3;
    }
    (y > 2 ? above : below).insert(mesh.split_vertices.ids[std::size_t(water.split_vertices[k])]);
    ++corners;
  }
  if (corners < 6) return;  // this rank does not hold the whole fan
  EXPECT_EQ(above.size(), 1U);
  EXPECT_EQ(below.size(), 1U);
  EXPECT_NE(above, below);
}

TEST(Sides, ABentLineThatWindsBack) {
  const auto mesh =
      with_cable(line("cable", {at(1, 1), at(2, 1), at(3, 1), at(3, 2), at(2, 2), at(1, 2)}));
  EXPECT_EQ(doubled(mesh),
            (std::map<int, int>{{at(2, 1), 2}, {at(3, 1), 2}, {at(3, 2), 2}, {at(2, 2), 2}}));
}

TEST(Sides, AnEndOnTheWallIsDouble) {
  const auto mesh = with_cable(line("cable", {at(0, 2), at(1, 2), at(2, 2)}));
  EXPECT_EQ(doubled(mesh), (std::map<int, int>{{at(0, 2), 2}, {at(1, 2), 2}}));
}

TEST(Sides, ABranchHasAPartPerSector) {
  auto cable = line("cable", {at(1, 2), at(2, 2), at(3, 2)});
  cable.cells.push_back({at(2, 2), at(2, 3)});
  const auto mesh = with_cable(cable);
  EXPECT_EQ(doubled(mesh), (std::map<int, int>{{at(2, 2), 3}}));
}

TEST(Sides, AClosedLoopSeparatesInsideFromOutside) {
  const auto mesh = with_cable(line("cable", {at(1, 1), at(2, 1), at(2, 2), at(1, 1)}));
  EXPECT_EQ(doubled(mesh), (std::map<int, int>{{at(1, 1), 2}, {at(2, 1), 2}, {at(2, 2), 2}}));
}

TEST(Sides, PartsOfTheBodyThatMeetInAPointShareOneSplitVertex) {
  MeshText text;
  text.nodes = {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  text.groups = {{"water", 2, {{0, 1, 2}, {0, 3, 4}}}};
  const auto mesh = read_text(Communicator(), text.in_format("2.2"));
  EXPECT_EQ(mesh.split_vertices.global_count, 5);
}

}  // namespace
}  // namespace hawser
