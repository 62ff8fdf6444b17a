#include "hawser/mesh/generate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "hawser/base/error.hpp"
#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

TowBox deep_tow() {
  TowBox box;
  box.min = {-4369.35, -5500};
  box.max = {4369.35, 4348.6};
  box.tail = {0, -420};
  box.cable_size = 20;
  return box;
}

TEST(Generate, TheQuickTow) {
  const Communicator all;
  const auto made = generate_mesh(all, deep_tow(), "tow.msh");
  EXPECT_THAT(made, testing::HasSubstr("21 cable segments"));
  const auto mesh = read_mesh(
      all, {"tow.msh", {"cable"}, 2, {Domain::patches("cable"), Domain::facets("inflow")}});
  EXPECT_GT(mesh.vertices.global_count, 1350);
  EXPECT_LT(mesh.vertices.global_count, 1500);
  EXPECT_EQ(mesh.split_vertices.global_count, mesh.vertices.global_count + 20);
  EXPECT_EQ(count_cells(mesh, "cable"), 21);
  EXPECT_EQ(count_cells(mesh, Domain::patches("cable")), 20);
  EXPECT_EQ(count_cells(mesh, "tow-point"), 1);
  EXPECT_EQ(count_cells(mesh, "tail"), 1);
  EXPECT_EQ(count_cells(mesh, Domain::facets("inflow")), count_cells(mesh, "top"));
  EXPECT_EQ(count_cells(mesh, "sides"), count_cells(mesh, "left") + count_cells(mesh, "right"));
  for (std::size_t c = 0; c < mesh.region("tow-point").vertices.size(); ++c) {
    const auto vertex = mesh.region("tow-point").vertices[c];
    EXPECT_EQ(mesh.coordinates[std::size_t(2 * vertex + 1)], 0);
  }
}

TEST(Generate, FinerEnds) {
  auto box = deep_tow();
  box.end_size = 5;
  const Communicator all;
  generate_mesh(all, box, "ends.msh");
  const auto mesh = read_mesh(all, {"ends.msh", {}});
  const auto& cable = mesh.region("cable");
  double shortest = 1e9;
  for (std::size_t c = 0; c < cable.cell_ids.size(); ++c) {
    const double* a = &mesh.coordinates[2 * std::size_t(cable.vertices[2 * c])];
    const double* b = &mesh.coordinates[2 * std::size_t(cable.vertices[2 * c + 1])];
    shortest = std::min(shortest, std::hypot(b[0] - a[0], b[1] - a[1]));
  }
  EXPECT_NEAR(all.min(shortest), 5, 1);
}

TEST(Generate, AStructuredGrid) {
  const Communicator all;
  WaterBox box;
  box.min = {0, 0}, box.max = {1, 1};
  box.cells = {4, 3};
  box.flow_direction = "+x";
  generate_mesh(all, box, "grid.msh");
  const auto mesh = read_mesh(all, {"grid.msh", {}});
  EXPECT_EQ(mesh.vertices.global_count, 20);
  EXPECT_EQ(count_cells(mesh, "water"), 24);
  EXPECT_EQ(count_cells(mesh, "inflow"), 3);
  EXPECT_EQ(count_cells(mesh, "sides"), 8);
  for (const auto v : mesh.region("outflow").vertices) {
    EXPECT_EQ(mesh.coordinates[std::size_t(2 * v)], 1);
  }
}

TEST(Generate, TheSameAgain) {
  const Communicator all;
  generate_mesh(all, deep_tow(), "once.msh");
  generate_mesh(all, deep_tow(), "twice.msh");
  if (!all.is_root()) return;
  std::ifstream once("once.msh"), twice("twice.msh");
  const std::istreambuf_iterator<char> end;
  EXPECT_TRUE(std::equal(std::istreambuf_iterator<char>(once), end,
                         std::istreambuf_iterator<char>(twice), end));
}

GeoMesh square() {
  std::ofstream("square.geo") << R"(DefineConstant[ length = {1, Name "length"} ];
    Point(1) = {0, 0, 0, length/4}; Point(2) = {length, 0, 0, length/4};
    Point(3) = {length, length, 0, length/4}; Point(4) = {0, length, 0, length/4};
    Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
    Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
    Physical Surface("water") = {1}; Physical Curve("wall") = {1, 2, 3, 4};
)";
  return {};
}

TEST(Generate, AGeometryWithNumbersFromTheDeck) {
  GeoMesh geo = square();
  geo.numbers.push_back({"length", 3});
  geo.refinements = 1;
  const Communicator all;
  generate_mesh(all, geo, "square.geo", "square.msh");
  const Mesh mesh = read_mesh(all, {"square.msh", {}, 2, {}});
  double largest = 0;
  for (const double x : mesh.coordinates)
    largest = std::max(largest, x);
  EXPECT_DOUBLE_EQ(all.max(largest), 3);
  const Region& wall = mesh.region("wall");
  EXPECT_EQ(all.sum(static_cast<long long>(
                std::count(wall.cell_owners.begin(), wall.cell_owners.end(), all.rank()))),
            32);  // four times four edges, halved
}

TEST(Generate, WhatIsWrongWithAGeometryIsTold) {
  GeoMesh geo = square();
  const auto refused = [&](const std::string& file, const std::string& sentence) {
    EXPECT_THAT([&] { generate_mesh(Communicator(), geo, file, "no.msh"); },
                testing::ThrowsMessage<MeshError>(testing::HasSubstr(sentence)));
  };
  geo.numbers.push_back({"lenght", 2});
  refused("square.geo",
          "square.geo has no constant 'lenght'; there are length; did you mean 'length'?");
  refused("sqare.geo", "cannot read sqare.geo");
  geo.numbers = {{"length", -3}};  // gmsh throws that where nobody can catch it
  refused("square.geo", "Wrong mesh element size");
  geo.numbers.clear();
  std::ofstream("broken.geo") << "Point(1) = {0, 0\n";
  refused("broken.geo", "syntax error");
  std::ofstream("open.geo") << "Point(1) = {0, 0, 0};";
  refused("open.geo", "open.geo ends without a line break");
  std::ofstream("empty.geo") << "Point(1) = {0, 0, 0};\n";
  refused("empty.geo", "makes no triangles");
}

void expect_refused(const TowBox& box, const std::string& path, const std::string& sentence) {
  EXPECT_THAT([&] { generate_mesh(Communicator(), box, path); },
              testing::ThrowsMessage<MeshError>("hawser_mesher: " + sentence));
}

TEST(Generate, RefusesWhatCannotBeMeshed) {
  auto box = deep_tow();
  box.tail[1] = -6000;
  expect_refused(box, "no.msh", "the cable's end (0, -6000) is not inside the box");
  box = deep_tow();
  box.cable_size = 0;
  expect_refused(box, "no.msh", "the cable size must be positive, given 0");
  box = deep_tow();
  box.far_size = 5;
  expect_refused(box, "no.msh", "the far size 5 is smaller than the cable size 20");
  box = deep_tow();
  box.growth = -1;
  expect_refused(box, "no.msh", "the growth must lie above 0 and not above 1, given -1");
  box = deep_tow();
  box.end_size = 30;
  expect_refused(box, "no.msh",
                 "the end size must not be negative nor exceed the cable size, given 30");
  box = deep_tow();
  box.max[0] = -5000;
  expect_refused(box, "no.msh",
                 "the box needs xmin < xmax and ymin < ymax, given -4369.35 -5500 -5000 4348.6");
  expect_refused(deep_tow(), "no/such/folder.msh", "cannot write no/such/folder.msh");
}

class OtherMesher : public testing::Test {
 protected:
  explicit OtherMesher() { setenv("HAWSER_MESHER", "./other_mesher", 1); }
  ~OtherMesher() override { unsetenv("HAWSER_MESHER"); }

  static std::string complaint_of(const std::string& script) {
    const Communicator all;
    if (all.is_root()) {
      std::ofstream("other_mesher") << "#!/bin/sh\n" << script << '\n';
      chmod("other_mesher", 0755);
    }
    try {
      generate_mesh(all, deep_tow(), "no.msh");
    } catch (const MeshError& error) {
      return error.what();
    }
    return "nothing";
  }
};

TEST_F(OtherMesher, DoesNotKnowOfMpirun) {
  EXPECT_EQ(complaint_of("env | grep -c -E '^(OMPI|PMIX|PRTE|PMI)_' >&2; exit 4"), "0");
}

TEST_F(OtherMesher, MayFailInAnyWay) {
  EXPECT_EQ(complaint_of("exit 1"), "./other_mesher failed without a word");
  EXPECT_EQ(complaint_of("kill -9 $$"), "./other_mesher was ended by signal 9");
  EXPECT_EQ(complaint_of("echo noise >&2; echo the last word >&2; exit 4"), "the last word");
  EXPECT_EQ(complaint_of("head -c 300000 /dev/zero; exit 1"),
            "./other_mesher failed without a word");
  setenv("HAWSER_MESHER", "/nowhere/mesher", 1);
  EXPECT_EQ(complaint_of(""), "cannot run /nowhere/mesher: No such file or directory");
}

}  // namespace
}  // namespace hawser
