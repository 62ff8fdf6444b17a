// Unions of lines, patches, facets and ends on a 4 by 4 grid; vertex (i, j) is number i + 5 j.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hawser/base/error.hpp"
#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

using testing::ElementsAre;

int at(int i, int j) { return i + 5 * j; }

Mesh with(const std::vector<MeshText::Group>& lines, const std::vector<Domain>& domains) {
  auto text = grid(4, 4);
  text.groups.insert(text.groups.end(), lines.begin(), lines.end());
  return read_text(Communicator(), text.in_format("4.1"), {}, domains);
}

Domain lines(const std::vector<std::string>& names) { return {names}; }

// This rank's cells as numbers of vertices.
std::vector<std::vector<GlobalIndex>> cells(const Mesh& mesh, const Domain& domain) {
  const Region& region = mesh.region(domain);
  const auto n = std::size_t(region.vertices_per_cell);
  std::vector<std::vector<GlobalIndex>> result(region.cell_ids.size());
  for (std::size_t k = 0; k < region.vertices.size(); ++k)
    result[k / n].push_back(mesh.vertices.ids[std::size_t(region.vertices[k])]);
  return result;
}

TEST(Patches, FollowTheLine) {
  const auto patches = Domain::patches("cable");
  const auto mesh = with({line("cable", {at(3, 2), at(2, 2), at(1, 2), at(1, 1)})}, {patches});
  EXPECT_EQ(count_cells(mesh, patches), 2);
  const auto here = cells(mesh, patches);
  for (std::size_t c = 0; c < here.size(); ++c)  // numbered by their middle vertices
    EXPECT_THAT(here[c], mesh.region(patches).cell_ids[c] == 0
                             ? ElementsAre(at(2, 2), at(1, 2), at(1, 1))
                             : ElementsAre(at(3, 2), at(2, 2), at(1, 2)));
}

TEST(Patches, AreThereOnTheBoundaryToo) {
  const auto mesh = with({}, {Domain::patches("wall")});
  EXPECT_EQ(count_cells(mesh, Domain::patches("wall")), 16);
}

TEST(Patches, GoOnWhereLinesOfOneListMeet) {
  const auto first = line("first", {at(1, 2), at(2, 2)});
  const auto second = line("second", {at(3, 2), at(2, 2)});
  const auto both = Domain::patches(lines({"first", "second"}));
  const auto mesh = with({first, second}, {both, Domain("water")});
  EXPECT_EQ(count_cells(mesh, both), 1);
  for (const auto& patch : cells(mesh, both))
    EXPECT_THAT(patch, ElementsAre(at(1, 2), at(2, 2), at(3, 2)));
  EXPECT_THAT(mesh.notes, testing::IsEmpty());
}

TEST(Patches, AreRefusedWhereALineBranches) {
  auto cable = line("cable", {at(1, 2), at(2, 2), at(3, 2)});
  cable.cells.push_back({at(2, 2), at(2, 3)});
  EXPECT_THAT([&] { with({cable}, {Domain::patches("cable")}); },
              testing::ThrowsMessage<MeshError>(
                  "the line of 'cable' branches at (2, 2), where there is no saying which of its "
                  "segments bend together; name the line that runs through and the one that is "
                  "hinged to it apart"));
  EXPECT_NO_THROW(with({cable}, {}));
}

TEST(Patches, OfLinesThatMeetAreNotedToBeHinged) {
  const auto through = line("through", {at(1, 2), at(2, 2), at(3, 2)});
  const auto branch = line("branch", {at(2, 2), at(2, 3), at(2, 4)});
  const auto mesh = with({through, branch},
                         {Domain::patches("through"), Domain::patches("branch"), Domain("water")});
  if (!mesh.communicator.is_root()) return;
  EXPECT_THAT(mesh.notes, ElementsAre("the lines of 'through' and 'branch' are hinged to each "
                                      "other at (2, 2); to bend together there, they must be of "
                                      "one module"));
}

TEST(Ends, BeginAtTheirPoint) {
  const auto cable = line("cable", {at(1, 2), at(2, 2), at(3, 2)});
  const auto ends = Domain::ends("cable", "middle");
  const auto mesh = with({cable, {"middle", 0, {{at(2, 2)}}}, {"off", 0, {{at(1, 1)}}}},
                         {ends, Domain::ends("cable", "off")});
  EXPECT_EQ(count_cells(mesh, ends), 2);
  for (const auto& end : cells(mesh, ends))
    EXPECT_EQ(end[0], at(2, 2));
  EXPECT_EQ(mesh.find(Domain::ends("cable", "off")), nullptr);
}

TEST(Unions, CountASegmentOfTwoLinesOnce) {
  const auto first = line("first", {at(1, 2), at(2, 2), at(3, 2)});
  const auto second = line("second", {at(3, 2), at(2, 2), at(2, 3)});
  const auto both = lines({"first", "second"});
  const auto mesh = with({first, second}, {both});
  EXPECT_EQ(count_cells(mesh, both), 3);
  if (mesh.communicator.size() == 1) {
    EXPECT_THAT(cells(mesh, both),
                ElementsAre(ElementsAre(at(1, 2), at(2, 2)), ElementsAre(at(2, 2), at(3, 2)),
                            ElementsAre(at(2, 2), at(2, 3))));
    EXPECT_THAT(places_in(mesh.region(both), mesh.region("second")), ElementsAre(1, 2));
  }
}

TEST(Unions, AreOfOneKindOfCells) {
  const auto both = lines({"water", "wall"});
  EXPECT_EQ(with({}, {both}).find(both), nullptr);
  EXPECT_EQ(with({}, {lines({"wall", "nowhere"})}).derived.size(), 0U);
}

TEST(Facets, HaveTheBodyOnTheLeft) {
  const auto facets_of_wall = Domain::facets("wall");
  const auto mesh =
      with({line("cable", {at(1, 2), at(2, 2)})}, {facets_of_wall, Domain::facets("cable")});
  EXPECT_EQ(mesh.find(Domain::facets("cable")), nullptr);
  const auto& facets = mesh.region(facets_of_wall);
  EXPECT_EQ(facets.dimension, 1);
  double enclosed = 0;
  for (std::size_t c = 0; c < facets.cell_ids.size(); ++c) {
    const auto x = [&](std::size_t k) {
      return &mesh.coordinates[2 * std::size_t(facets.vertices[3 * c + k])];
    };
    EXPECT_GT(triangle_quality(x(0), x(1), x(2)), 0);
    if (facets.cell_owners[c] == mesh.communicator.rank()) {
      enclosed += (x(0)[0] * x(1)[1] - x(0)[1] * x(1)[0]) / 2;
    }
    for (std::size_t k = 3 * c; k < 3 * c + 3; ++k) {
      const auto split = std::size_t(facets.split_vertices[k]);
      EXPECT_EQ(mesh.vertex_of_split[split], facets.vertices[k]);
    }
  }
  EXPECT_DOUBLE_EQ(mesh.communicator.sum(enclosed), 16);
}

}  // namespace
}  // namespace hawser
