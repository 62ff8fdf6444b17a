#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../src/graph.hpp"
#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

// The numbers of some local points, in the numbering that all ranks share.
std::vector<GlobalIndex> global(const PointSet& points, const std::vector<LocalIndex>& numbers) {
  std::vector<GlobalIndex> result;
  for (const auto n : numbers)
    result.push_back(points.ids.at(std::size_t(n)));
  return result;
}

template <class T>
std::vector<T> cell(const std::vector<T>& all, std::size_t cells, std::size_t c) {
  const auto size = cells == 0 ? 0 : all.size() / cells;
  return {all.begin() + std::ptrdiff_t(c * size), all.begin() + std::ptrdiff_t((c + 1) * size)};
}

void expect_owned_once(const Communicator& all, const PointSet& points) {
  std::vector<int> owner(std::size_t(points.global_count), 0), count = owner;
  for (std::size_t k = 0; k < points.ids.size(); ++k) {
    EXPECT_EQ(k < std::size_t(points.owned), points.owners[k] == all.rank());
    if (points.owners[k] != all.rank()) continue;
    owner[std::size_t(points.ids[k])] = all.rank();
    ++count[std::size_t(points.ids[k])];
  }
  const auto n = int(owner.size());
  MPI_Allreduce(MPI_IN_PLACE, owner.data(), n, MPI_INT, MPI_SUM, all.mpi());
  MPI_Allreduce(MPI_IN_PLACE, count.data(), n, MPI_INT, MPI_SUM, all.mpi());
  EXPECT_THAT(count, testing::Each(1));
  for (std::size_t k = 0; k < points.ids.size(); ++k) {
    EXPECT_EQ(points.owners[k], owner[std::size_t(points.ids[k])]);
  }
}

void expect_ghosts_by_owner(const PointSet& points) {
  for (std::size_t k = std::size_t(points.owned) + 1; k < points.ids.size(); ++k) {
    EXPECT_LT(std::pair(points.owners[k - 1], points.ids[k - 1]),
              std::pair(points.owners[k], points.ids[k]));
  }
}

// Against the whole mesh, which every rank reads for itself.
void expect_sound_parts(const MeshText& text, const std::vector<std::string>& slits,
                        const std::vector<Domain>& domains) {
  const Communicator all, alone(MPI_COMM_SELF);
  const auto part = read_text(all, text.in_format("4.1"), slits, domains);
  const auto whole = read_mesh(alone, {"test.msh", slits, 2, domains});
  for (const auto points : {&Mesh::vertices, &Mesh::split_vertices, &Mesh::edges}) {
    EXPECT_EQ((part.*points).global_count, (whole.*points).owned);
    expect_owned_once(all, part.*points);
  }
  expect_ghosts_by_owner(part.vertices);
  for (std::size_t e = 0; e < part.edges.ids.size(); ++e) {
    const auto a = std::size_t(part.edge_ends[2 * e]), b = std::size_t(part.edge_ends[2 * e + 1]);
    const auto lower = part.vertices.ids[a] < part.vertices.ids[b] ? a : b;
    EXPECT_EQ(part.edges.owners[e], part.vertices.owners[lower]);
  }
  for (std::size_t s = 0; s < part.split_vertices.ids.size(); ++s) {
    const auto vertex = std::size_t(part.vertex_of_split[s]);
    EXPECT_EQ(part.split_vertices.owners[s], part.vertices.owners[vertex]);
  }

  const std::set<GlobalIndex> owned(part.vertices.ids.begin(),
                                    part.vertices.ids.begin() + part.vertices.owned);
  std::vector<const Region*> wanted = {&whole.body}, found = {&part.body};
  ASSERT_EQ(part.regions.size(), whole.regions.size());
  for (const auto& region : whole.regions) {
    wanted.push_back(&region);
    found.push_back(&part.region(region.name));
  }
  ASSERT_EQ(whole.derived.size(), domains.size());
  for (const auto& domain : domains) {
    wanted.push_back(&whole.region(domain));
    found.push_back(&part.region(domain));
  }
  for (std::size_t r = 0; r < wanted.size(); ++r) {
    const auto &here = *found[r], &there = *wanted[r];
    SCOPED_TRACE(there.name);
    EXPECT_EQ(here.name, there.name);
    EXPECT_EQ(here.shape, there.shape);
    EXPECT_EQ(here.dimension, there.dimension);
    EXPECT_EQ(here.vertices_per_cell, there.vertices_per_cell);
    std::size_t next = 0;
    long long counted = 0;
    for (std::size_t c = 0; c < there.cell_ids.size(); ++c) {
      const auto n = there.cell_ids.size(), m = here.cell_ids.size();
      const auto vertices = global(whole.vertices, cell(there.vertices, n, c));
      const auto mine = [&](GlobalIndex v) { return owned.count(v) > 0; };
      if (std::none_of(vertices.begin(), vertices.end(), mine)) continue;
      ASSERT_LT(next, m);
      EXPECT_EQ(here.cell_ids[next], there.cell_ids[c]);
      EXPECT_EQ(global(part.vertices, cell(here.vertices, m, next)), vertices);
      EXPECT_EQ(global(part.split_vertices, cell(here.split_vertices, m, next)),
                global(whole.split_vertices, cell(there.split_vertices, n, c)));
      EXPECT_EQ(global(part.edges, cell(here.edges, m, next)),
                global(whole.edges, cell(there.edges, n, c)));
      const bool counts = mine(*std::min_element(vertices.begin(), vertices.end()));
      EXPECT_EQ(here.cell_owners[next] == all.rank(), counts);
      counted += counts;
      ++next;
    }
    EXPECT_EQ(next, here.cell_ids.size());
    EXPECT_EQ(all.sum(counted), static_cast<long long>(there.cell_ids.size()));
  }
}

TEST(Distribution, OfAGridWithACable) {
  auto text = grid(8, 6);
  text.groups.push_back(line("cable", {28, 29, 30, 31, 32, 33}));
  text.groups.push_back({"tow-point", 0, {{28}}});
  text.groups.push_back(line("branch", {31, 40, 49}));
  text.groups.push_back({"part", 2, {text.groups[0].cells[3], text.groups[0].cells[40]}});
  expect_sound_parts(text, {"cable"},
                     {Domain::patches("cable"), Domain::ends("cable", "tow-point"),
                      Domain::facets("wall"), Domain(std::vector<std::string>{"cable", "branch"}),
                      Domain(std::vector<std::string>{"part", "water"})});
}

TEST(Distribution, OfMoreRanksThanVertices) {
  MeshText text;
  text.nodes = {{0, 0}, {1, 0}, {0, 1}};
  text.groups = {{"water", 2, {{0, 1, 2}}}, {"wall", 1, {{0, 1}}}};
  expect_sound_parts(text, {}, {Domain::facets("wall")});
}

TEST(Distribution, OfAChainAlone) {
  MeshText text;
  std::vector<int> vertices;
  for (int k = 0; k < 60; ++k) {
    text.nodes.push_back({double(k), 0});
    vertices.push_back(k);
  }
  text.groups = {line("chain", vertices)};
  expect_sound_parts(text, {}, {Domain::patches("chain")});
}

TEST(Distribution, IsBalancedAndTheSameAgain) {
  const Communicator all;
  const auto text = grid(20, 20).in_format("2.2");
  const auto mesh = read_text(all, text), again = read_text(all, text);
  EXPECT_EQ(mesh.vertices.ids, again.vertices.ids);
  EXPECT_LE(all.max(double(mesh.vertices.owned)), 1.1 * 441 / all.size());
}

TEST(Distribution, SumsOverOwnedCellsDoNotDependOnTheRanks) {
  const Communicator all;
  const auto mesh = read_text(all, grid(7, 5).in_format("4.1"));
  const auto& water = mesh.region("water");
  double area = 0;
  for (std::size_t c = 0; c < water.cell_ids.size(); ++c) {
    if (water.cell_owners[c] != all.rank()) continue;
    const auto x = [&](std::size_t k) {
      return &mesh.coordinates[2 * std::size_t(water.vertices[3 * c + k])];
    };
    area +=
        ((x(1)[0] - x(0)[0]) * (x(2)[1] - x(0)[1]) - (x(2)[0] - x(0)[0]) * (x(1)[1] - x(0)[1])) / 2;
  }
  EXPECT_DOUBLE_EQ(all.sum(area), 35);
}

TEST(Graph, CuthillMcKeeFindsTheNarrowOrder) {
  // A path whose vertices are numbered at random, and a vertex apart.
  const auto graph = make_graph(7, {3, 0, 0, 5, 5, 1, 1, 4, 4, 2});
  const auto order = reverse_cuthill_mckee(graph);
  EXPECT_THAT(order, testing::AnyOf(testing::ElementsAre(3, 0, 5, 1, 4, 2, 6),
                                    testing::ElementsAre(2, 4, 1, 5, 0, 3, 6)));
}

TEST(Graph, NoPartStaysEmptyWhereThereAreVertices) {
  for (int parts = 1; parts <= 6; ++parts) {
    for (LocalIndex n = parts; n < 60; ++n) {
      std::vector<LocalIndex> ends;
      for (LocalIndex v = 1; v < n; ++v)
        ends.insert(ends.end(), {v - 1, v});
      const auto part_of = partition(make_graph(n, ends), parts);
      EXPECT_EQ(std::set<int>(part_of.begin(), part_of.end()).size(), std::size_t(parts));
    }
  }
}

}  // namespace
}  // namespace hawser
