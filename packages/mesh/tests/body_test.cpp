// The union of surface groups, on 2 by 2 squares of two triangles each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

using Ids = std::vector<GlobalIndex>;

// The cells of the grid in the groups named, by their numbers in the grid.
Mesh with_groups(const std::map<std::string, std::vector<std::size_t>>& groups,
                 const std::vector<Domain>& domains = {}) {
  auto text = grid(2, 2);
  const auto cells = text.groups[0].cells;
  text.groups.erase(text.groups.begin());
  for (const auto& [name, members] : groups) {
    text.groups.push_back({name, 2, {}});
    for (const auto cell : members)
      text.groups.back().cells.push_back(cells[cell]);
  }
  return read_text(Communicator(), text.in_format("4.1"), {}, domains);
}

// Of all ranks, ascending.
Ids owned_ids(const Mesh& mesh, const Region& region) {
  std::vector<int> count(8, 0);
  for (std::size_t c = 0; c < region.cell_ids.size(); ++c)
    if (region.cell_owners[c] == mesh.communicator.rank()) ++count[std::size_t(region.cell_ids[c])];
  MPI_Allreduce(MPI_IN_PLACE, count.data(), 8, MPI_INT, MPI_SUM, mesh.communicator.mpi());
  Ids ids;
  for (std::size_t id = 0; id < count.size(); ++id)
    ids.insert(ids.end(), std::size_t(count[id]), GlobalIndex(id));
  return ids;
}

// The same number, wherever it stands, is the same cell.
void expect_cells_of_the_body(const Mesh& mesh, const Region& region) {
  std::map<GlobalIndex, std::size_t> place;
  for (std::size_t c = 0; c < mesh.body.cell_ids.size(); ++c)
    place[mesh.body.cell_ids[c]] = c;
  for (std::size_t c = 0; c < region.cell_ids.size(); ++c) {
    const auto b = place.at(region.cell_ids[c]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(region.vertices[3 * c + k], mesh.body.vertices[3 * b + k]);
      EXPECT_EQ(region.split_vertices[3 * c + k], mesh.body.split_vertices[3 * b + k]);
      EXPECT_EQ(region.edges[3 * c + k], mesh.body.edges[3 * b + k]);
    }
    EXPECT_EQ(region.cell_owners[c], mesh.body.cell_owners[b]);
  }
}

TEST(Body, CountsTheCellsOfTwoGroupsThrough) {
  const auto mesh = with_groups({{"left", {0, 1, 4, 5}}, {"right", {2, 3, 6, 7}}});
  EXPECT_TRUE(mesh.has_body());
  EXPECT_EQ(owned_ids(mesh, mesh.body), (Ids{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(owned_ids(mesh, mesh.region("left")), (Ids{0, 1, 2, 3}));
  EXPECT_EQ(owned_ids(mesh, mesh.region("right")), (Ids{4, 5, 6, 7}));
  expect_cells_of_the_body(mesh, mesh.region("left"));
  expect_cells_of_the_body(mesh, mesh.region("right"));
}

TEST(Body, HoldsACellOfTwoGroupsOnce) {
  const auto mesh = with_groups({{"a", {3, 0, 1, 2, 4, 5, 6, 7}}, {"b", {5, 1, 3}}});
  EXPECT_EQ(owned_ids(mesh, mesh.body), (Ids{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(owned_ids(mesh, mesh.region("b")), (Ids{0, 2, 5}));
  expect_cells_of_the_body(mesh, mesh.region("b"));
}

TEST(Body, TheSameSurfaceMayHaveTwoNames) {
  const std::vector<std::size_t> all = {0, 1, 2, 3, 4, 5, 6, 7};
  const auto mesh = with_groups({{"sea", all}, {"water", all}});
  EXPECT_EQ(owned_ids(mesh, mesh.body), (Ids{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(mesh.region("sea").cell_ids, mesh.region("water").cell_ids);
}

TEST(Body, AListOfGroupsIsTheirUnion) {
  const Domain both(std::vector<std::string>{"b", "a"});
  const auto mesh = with_groups({{"a", {0, 1, 2, 3}}, {"b", {2, 3, 4}}, {"c", {5, 6, 7}}}, {both});
  EXPECT_EQ(owned_ids(mesh, mesh.region(both)), (Ids{0, 1, 2, 3, 4}));
  expect_cells_of_the_body(mesh, mesh.region(both));
}

}  // namespace
}  // namespace hawser
