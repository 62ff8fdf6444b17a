// What is wrong with a mesh is told before anything is solved on it: each kind of fault, varied.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

Mesh read(const MeshText& text, const MeshOptions& options = {}) {
  const Communicator world;
  if (world.is_root()) std::ofstream("audit.msh") << text.in_format("4.1");
  MPI_Barrier(world.mpi());
  MeshOptions all = options;
  all.file = "audit.msh";
  return read_mesh(world, all);
}

MeshOptions with_modules(std::vector<Domain> domains) {
  MeshOptions options;
  options.domains = std::move(domains);
  return options;
}

/// Two grids of n by n beside each other, each with its own nodes; `gap` between them.
MeshText halves(int n, double size, double gap, double angle) {
  MeshText mesh = grid(n, n);
  MeshText other = grid(n, n);
  for (auto& node : other.nodes)
    node[0] += n + gap;
  const int shift = static_cast<int>(mesh.nodes.size());
  for (std::size_t g = 0; g < 2; ++g)
    for (auto cell : other.groups[g].cells) {
      for (int& v : cell)
        v += shift;
      mesh.groups[g].cells.push_back(cell);
    }
  mesh.nodes.insert(mesh.nodes.end(), other.nodes.begin(), other.nodes.end());
  for (auto& [x, y] : mesh.nodes) {
    const double u = size * (x * std::cos(angle) - y * std::sin(angle)) + 3;
    y = size * (x * std::sin(angle) + y * std::cos(angle)) - 7;
    x = u;
  }
  return mesh;
}

TEST(Audit, AGoodMeshHasNoNotes) {
  const auto mesh = read(grid(3, 2), with_modules({Domain("water")}));
  if (mesh.communicator.is_root()) {
    EXPECT_THAT(mesh.notes, IsEmpty());
  }
}

struct Doubling {
  int n;
  double size, gap, angle;  // gap in edges
};
class DoubledInterface : public testing::TestWithParam<Doubling> {};

TEST_P(DoubledInterface, IsRefusedWithItsPlaces) {
  const Doubling& of = GetParam();
  const auto text = halves(of.n, of.size, of.gap, of.angle);
  EXPECT_THAT(
      [&] { read(text); },
      ThrowsMessage<MeshError>(AllOf(
          HasSubstr("several nodes at one place, at " + std::to_string(of.n + 1) + " places: at ("),
          HasSubstr("'water', 'wall'"), HasSubstr("BooleanFragments"))));
}

INSTANTIATE_TEST_SUITE_P(Varied, DoubledInterface,
                         testing::Values(Doubling{2, 1, 0, 0}, Doubling{3, 0.01, 0, 0.3},
                                         Doubling{4, 1e3, 0, 1}, Doubling{5, 1e-4, 0, 2},
                                         Doubling{2, 1, 1e-12, 0}, Doubling{3, 1, 1e-9, 0.3},
                                         Doubling{4, 1, 1e-7, 1}, Doubling{5, 1, 1e-5, 2},
                                         Doubling{6, 1e5, 1e-3, 3}, Doubling{7, 1, 5e-3, 0.7}));

// Meshed apart, and with other nodes: two squares of n and m squares along their common side, the
// second one moved along it.
struct Hanging {
  int n, m;
  double shift;
  int nodes;
};
class HangingNodes : public testing::TestWithParam<Hanging> {};

TEST_P(HangingNodes, AreRefusedWithTheirPlaces) {
  const Hanging& of = GetParam();
  MeshText text = grid(of.n, of.n);
  for (auto& node : text.nodes)
    node = {node[0] / of.n, node[1] / of.n};
  const MeshText other = grid(of.m, of.m);
  const int first = static_cast<int>(text.nodes.size());
  for (const auto& node : other.nodes)
    text.nodes.push_back({1 + node[0] / of.m, node[1] / of.m + of.shift});
  for (std::size_t g = 0; g < 2; ++g)
    for (auto cell : other.groups[g].cells) {
      for (int& v : cell)
        v += first;
      text.groups[g].cells.push_back(cell);
    }
  EXPECT_THAT([&] { read(text); },
              ThrowsMessage<MeshError>(HasSubstr(
                  std::to_string(of.nodes) + (of.nodes == 1 ? " node" : " nodes") +
                  " of the boundary " + (of.nodes == 1 ? "lies" : "lie") + " on edges of it")));
}

INSTANTIATE_TEST_SUITE_P(Varied, HangingNodes,
                         testing::Values(Hanging{4, 3, 0, 5}, Hanging{2, 3, 0, 3},
                                         Hanging{1, 2, 0, 1}, Hanging{1, 7, 0, 6},
                                         Hanging{5, 6, 0, 9}, Hanging{2, 2, 0.25, 4},
                                         Hanging{3, 3, -0.1, 6}, Hanging{2, 4, 0.125, 6},
                                         Hanging{1, 1, 0.5, 2}, Hanging{8, 1, -0.5, 4}));

TEST(Audit, HalvesWithAGapAreTwoParts) {
  const auto mesh = read(halves(2, 1, 0.5, 0));
  if (!mesh.communicator.is_root()) return;
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr(
                              "the body is in 2 parts that share no edge: 8 cells from (3, -7), 8 "
                              "cells from (5.5, -7); nothing flows")));
}

TEST(Audit, WhatIsMeantToBeApartIsNoFinding) {
  auto text = halves(2, 1, 0, 0);
  text.groups.push_back({"left", 2, {}});
  text.groups.push_back({"right", 2, {}});
  for (std::size_t c = 0; c < 16; ++c)
    text.groups[c < 8 ? 2 : 3].cells.push_back(text.groups[0].cells[c]);
  MeshOptions options;
  options.apart = {"left", "right"};
  const auto mesh = read(text, options);
  if (mesh.communicator.is_root()) {
    EXPECT_THAT(mesh.notes, IsEmpty());
  }
  options.apart = {"middle"};
  EXPECT_THAT([&] { read(text, options); },
              ThrowsMessage<MeshError>(HasSubstr("the mesh has no region 'middle'")));
}

TEST(Audit, PartsOverEachOtherAreRefused) {
  for (const double shift : {0.3, 0.51, 0.77, 1.2, 1.9, 2.4, 3.1, 3.6}) {
    const auto text = halves(4, 1, shift - 4.2, 0.1);
    EXPECT_THAT([&] { read(text); },
                ThrowsMessage<MeshError>(HasSubstr("parts of the body lie over each other: ")))
        << shift;
  }
}

/// A grid in which a line named 'cable' lies, of nodes of its own from (x, 0.4) upwards.
MeshText beside(int cells, double x) {
  MeshText mesh = grid(4, 4);
  std::vector<int> vertices;
  for (int k = 0; k <= cells; ++k) {
    vertices.push_back(static_cast<int>(mesh.nodes.size()));
    mesh.nodes.push_back({x, 0.4 + 3.0 * k / cells});
  }
  mesh.groups.push_back(line("cable", vertices));
  return mesh;
}

class NotEmbedded : public testing::TestWithParam<std::pair<int, double>> {};

TEST_P(NotEmbedded, IsRefusedWhereAModuleLivesOnIt) {
  const auto [cells, x] = GetParam();
  const auto text = beside(cells, x);
  const std::string count = std::to_string(cells);
  for (const bool slit : {false, true}) {
    MeshOptions options = with_modules({Domain("water")});
    if (slit)
      options.slits = {"cable"};
    else
      options.domains.push_back(Domain("cable"));
    EXPECT_THAT([&] { read(text, options); },
                ThrowsMessage<MeshError>(
                    AllOf(HasSubstr(count + " of the " + count + (cells == 1 ? " edge" : " edges") +
                                    " of 'cable' belong"),
                          HasSubstr("to no cell of the body: from ("), HasSubstr("In Surface{...}"),
                          HasSubstr("<mesh apart=\"cable\">"))));
    options.apart = {"cable"};
    EXPECT_NO_THROW(read(text, options));
  }
}

INSTANTIATE_TEST_SUITE_P(Varied, NotEmbedded,
                         testing::Values(std::pair{1, 0.5}, std::pair{2, 0.5}, std::pair{3, 1.25},
                                         std::pair{4, 2.0}, std::pair{5, 2.6}, std::pair{7, 3.3},
                                         std::pair{9, 3.9}, std::pair{12, -1.0}, std::pair{20, 5.0},
                                         std::pair{33, 0.01}));

TEST(Audit, ACableThatLeavesTheWaterIsRefused) {
  MeshText text = grid(2, 2);
  text.nodes.push_back({1, 3});
  text.groups.push_back(line("cable", {1, 4, 7, 9}));
  EXPECT_THAT(
      [&] {
        read(text, with_modules({Domain("water"), Domain("cable")}));
      },
      ThrowsMessage<MeshError>(HasSubstr("1 of the 3 edges of 'cable' belongs to no cell "
                                         "of the body: from (1, 2) to (1, 3), 1 m")));
}

TEST(Audit, ALineThatNobodyUsesIsNoted) {
  const auto mesh = read(beside(2, 0.5), with_modules({Domain("water")}));
  if (!mesh.communicator.is_root()) return;
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("2 of the 2 edges of 'cable' belong to no cell")));
}

TEST(Audit, ALineAloneIsNoFault) {
  MeshText text;
  text.nodes = {{0, 0}, {1, 0}, {2, 0}};
  text.groups = {line("cable", {0, 1, 2})};
  const auto mesh = read(text, with_modules({Domain("cable")}));
  EXPECT_THAT(mesh.notes, IsEmpty());
}

TEST(Audit, EdgesWithoutLengthAreRefused) {
  MeshText text;
  text.nodes = {{0, 0}, {1, 0}, {1, 0}, {2, 0}};
  text.groups = {line("cable", {0, 1, 2, 3})};
  EXPECT_THAT([&] { read(text); },
              ThrowsMessage<MeshError>(HasSubstr("1 edge of 'cable' has no length, at (1, 0)")));
}

TEST(Audit, ALineInTwoPiecesThatMeetIsRefused) {
  MeshText text;
  text.nodes = {{0, 0}, {1, 0}, {1, 0}, {2, 0}};
  text.groups = {line("lead", {0, 1}), line("array", {2, 3})};
  EXPECT_THAT([&] { read(text); },
              ThrowsMessage<MeshError>(HasSubstr("at 1 place: at (1, 0) in 'lead', 'array'")));
}

class MissingWall : public testing::TestWithParam<int> {};

// Of the 12 boundary edges of 4 by 2 squares every run of consecutive ones that a mesh may miss.
TEST_P(MissingWall, IsNotedWithItsPlace) {
  MeshText text = grid(4, 2);
  auto& wall = text.groups[1].cells;
  const auto missing = static_cast<std::size_t>(GetParam());
  // The bottom goes first, then the top, the left and the right side.
  const std::string from = missing <= 8   ? "(0, 0) to ("
                           : missing == 9 ? "(4, 0) to (0, 1), 5 m; from (0, 2) to (4, 2), 4 m;"
                                          : "(4, 0) to (4, 2), 10 m;";
  wall.erase(wall.begin(), wall.begin() + static_cast<std::ptrdiff_t>(missing));
  const auto mesh = read(text);
  MeshOptions meant;
  meant.open_boundary = true;
  EXPECT_THAT(read(text, meant).notes, IsEmpty());
  if (!mesh.communicator.is_root()) return;
  EXPECT_THAT(mesh.notes,
              ElementsAre(AllOf(
                  HasSubstr(std::to_string(missing) + " edge"), HasSubstr("of the body's boundary"),
                  HasSubstr("in no region: from " + from), HasSubstr("open-boundary=\"true\""))));
}

INSTANTIATE_TEST_SUITE_P(Varied, MissingWall, testing::Range(1, 11));

TEST(Audit, ABoundaryThatIsNamedNowhereIsARing) {
  MeshText text = grid(2, 2);
  text.groups.pop_back();
  const auto mesh = read(text);
  if (!mesh.communicator.is_root()) return;
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("8 edges of the body's boundary are in no region: "
                                                "a ring through (0, 0), 8 m;")));
}

TEST(Audit, CellsInNoModuleAreNoted) {
  MeshText text = grid(4, 1);
  text.groups.push_back({"far", 2, {}});
  auto& water = text.groups[0].cells;
  for (int k = 0; k < 2; ++k, water.pop_back())
    text.groups[2].cells.push_back(water.back());
  const auto mesh = read(text, with_modules({Domain("water")}));
  const auto all = read(text, with_modules({Domain(std::vector<std::string>{"water", "far"})}));
  EXPECT_THAT(all.notes, IsEmpty());
  if (!mesh.communicator.is_root()) return;
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("2 cells of the body's 8, of 'far', belong to no "
                                                "module, at (3, 0)")));
}

TEST(Audit, RegionsOfTheSameCellsAreNoFault) {
  MeshText text = grid(3, 3);
  text.groups.push_back(text.groups[0]);
  text.groups.back().name = "again";
  text.groups.push_back(text.groups[1]);
  text.groups.back().name = "edge again";
  const auto mesh = read(text, with_modules({Domain("water")}));
  EXPECT_THAT(mesh.notes, IsEmpty());
  EXPECT_EQ(count_cells(mesh, "again"), 18);
  long long mine = 0;
  for (const int owner : mesh.body.cell_owners)
    mine += owner == mesh.communicator.rank() ? 1 : 0;
  EXPECT_EQ(mesh.communicator.sum(mine), 18);
}

TEST(Audit, APointOfNoCellIsNoted) {
  MeshText text = grid(2, 2);
  text.nodes.push_back({0.7, 0.3});
  text.groups.push_back({"pin", 0, {{9}}});
  const auto mesh = read(text);
  if (!mesh.communicator.is_root()) return;
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("1 node of 'pin' belongs to no line and no cell, "
                                                "at (0.7, 0.3)")));
}

TEST(Audit, NodesOfNoElementAreNoted) {
  MeshText text = grid(2, 2);
  text.nodes.push_back({9, 9});
  const auto mesh = read(text);
  if (!mesh.communicator.is_root()) return;
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("1 node of the mesh file in no element")));
}

TEST(Audit, NearlyFlatCellsAreNoted) {
  MeshText text = grid(2, 2);
  text.nodes[4] = {1, 1e-5};
  const auto mesh = read(text);
  if (!mesh.communicator.is_root()) return;
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("nearly flat, of quality ")));
}

TEST(Audit, AnOutflowPartlyInsideIsRefused) {
  MeshText text = grid(2, 2);
  text.groups.push_back(line("outflow", {0, 3, 4}));
  EXPECT_THAT(
      [&] {
        read(text, with_modules({Domain("water"), Domain::facets("outflow")}));
      },
      ThrowsMessage<MeshError>(HasSubstr("1 of the 2 edges of 'outflow' are not on the "
                                         "boundary but inside the body: from (0, 1) to (1, 1)")));
}

TEST(Audit, SeveralFaultsAreToldTogether) {
  auto text = halves(2, 1, 0, 0);
  text.nodes.push_back({100, 0});
  text.nodes.push_back({101, 0});
  text.groups.push_back(line("cable", {18, 19}));
  EXPECT_THAT([&] { read(text, with_modules({Domain("cable")})); },
              ThrowsMessage<MeshError>(testing::ContainsRegex("several nodes.*\n1 of the 1 edge")));
}

}  // namespace
}  // namespace hawser
