// What a user sees of a mesh file that is no good, to the letter.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hawser/base/error.hpp"
#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

const std::string good = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "wall"
2 2 "water"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 0 1 0
4 2 0 0
$EndNodes
$Elements
2
1 1 2 1 1 1 2
2 2 2 2 2 1 2 3
$EndElements
)";

struct Fault {
  std::string name, old_text, new_text, message;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class Malformed : public testing::TestWithParam<Fault> {};

TEST_P(Malformed, IsRefusedOnAllRanks) {
  const auto& fault = GetParam();
  auto text = good;
  const auto place = text.find(fault.old_text);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, fault.old_text.size(), fault.new_text);
  EXPECT_THAT([&] { read_text(Communicator(), text); },
              testing::ThrowsMessage<MeshError>("test.msh" + fault.message));
}

INSTANTIATE_TEST_SUITE_P(
    Files, Malformed,
    testing::Values(
        Fault{"NoMesh", "$MeshFormat", "solid", ":1: expected $MeshFormat: no MSH file"},
        Fault{"ByteOrderMark", "$MeshFormat", "\xEF\xBB\xBF$MeshFormat",
              ":1: the file begins with a byte-order mark; save it without one"},
        Fault{"OldVersion", "2.2 0", "4 0",
              ":2: MSH format 4 is not read; write 4.1 or 2.2 (Mesh.MshFileVersion)"},
        Fault{"BinaryOfFourBytes", "2.2 0 8", "2.2 1 4",
              ":2: numbers of 4 bytes are not read, only of 8"},
        Fault{"UnclosedSection", "$EndNodes", "5 3 3 0", ":15: expected $EndNodes, found '5'"},
        Fault{"Coordinate", "1 0 0 0", "1 0 o 0", ":11: expected a coordinate, found 'o'"},
        Fault{"NotFinite", "1 0 0 0", "1 0 nan 0", ":11: expected a coordinate, found 'nan'"},
        Fault{"FewCoordinates", "1 0 0 0", "1 0 0",
              ":11: expected a coordinate, found the end of the line"},
        Fault{"TwiceDefined", "4 2 0 0", "3 2 0 0", ":14: node 3 is defined twice"},
        Fault{"OffThePlane", "2 1 0 0", "2 1 0 3",
              ":12: node 2 lies off the plane z = 0; a mesh of lines in space is read with "
              "dimension=\"3\""},
        Fault{"NoSuchNode", "2 2 1 2 3", "2 2 1 2 5",
              ":19: element 2 refers to node 5, which the file does not define"},
        Fault{"FewNodes", "2 2 1 2 3", "2 2 1 2",
              ":19: expected a node of element 2, found the end of the line"},
        Fault{"ManyNodes", "2 2 1 2 3", "2 2 1 2 3 4",
              ":19: '4' is too much after the nodes of element 2"},
        Fault{"SameNode", "2 2 1 2 3", "2 2 1 2 2", ":19: element 2 names node 2 twice"},
        Fault{"NoArea", "2 2 1 2 3", "2 2 1 2 4",
              ":19: element 2 of 'water' is flat or folded over"},
        Fault{"Quadrilateral", "2 2 2 2 2 1 2 3", "2 3 2 2 2 1 2 4 3",
              ":19: element 2 is a quadrilateral; only points, lines and triangles of first order "
              "are read: mesh without Recombine (Mesh.RecombineAll = 0)"},
        Fault{"SecondOrder", "2 2 2 2 2 1 2 3", "2 9 2 2 2 1 2 3 4 5 6",
              ":19: element 2 is a triangle of higher order; only points, lines and triangles of "
              "first order are read: write it with Mesh.ElementOrder = 1"},
        Fault{"Tetrahedron", "2 2 2 2 2 1 2 3", "2 4 2 2 2 1 2 3 4",
              ":19: element 2 is a tetrahedron; only points, lines and triangles of first order "
              "are read: mesh the plane only (gmsh -2)"},
        Fault{"OfAStrangeType", "2 2 2 2 2 1 2 3", "2 999 2 2 2 1 2 3 4",
              ":19: element 2 is of gmsh's type 999; only points, lines and triangles of first "
              "order are read: mesh with gmsh -2 -order 1"},
        Fault{"Again", "2\n1 1 2", "3\n7 1 2 1 1 2 1\n1 1 2",
              ":19: element 1 of 'wall' has the same nodes as element 7"},
        Fault{"SameName", "\"water\"", "\"wall\"", ":7: two physical groups are named 'wall'"},
        Fault{"Slash", "\"wall\"", "\"a/b\"",
              ":6: the name 'a/b' of a physical group is empty or holds a slash"},
        Fault{"TooManyAnnounced", "4\n1 0", "5\n1 0",
              ":15: expected a node number, found '$EndNodes'"},
        Fault{"Truncated", "$EndElements\n", "",
              ":19: the file ends where $EndElements was expected"}),
    [](const auto& fault) { return fault.param.name; });

TEST(Malformed, NoSuchFile) {
  EXPECT_THAT(
      [] {
        read_mesh(Communicator(), {"nowhere.msh", {}});
      },
      testing::ThrowsMessage<MeshError>("cannot open the mesh file nowhere.msh"));
}

TEST(Malformed, NoFileAtAll) {
  EXPECT_THAT(
      [] {
        read_mesh(Communicator(), {".", {}});
      },
      testing::ThrowsMessage<MeshError>(". is a folder, no mesh file"));
  EXPECT_THAT(
      [] {
        read_mesh(Communicator(), {"/dev/zero", {}});
      },
      testing::ThrowsMessage<MeshError>("/dev/zero is no mesh file but a pipe or a device"));
  EXPECT_THAT([] { read_text(Communicator(), ""); },
              testing::ThrowsMessage<MeshError>("test.msh:1: the file is empty"));
}

TEST(Malformed, OverlappingTriangles) {
  auto text = grid(1, 1);
  text.groups[0].cells.push_back({0, 1, 2});
  EXPECT_THAT([&] { read_text(Communicator(), text.in_format("4.1")); },
              testing::ThrowsMessage<MeshError>("two cells overlap on the same side of the "
                                                "edge from (0, 0) to (1, 0)"));
}

TEST(Malformed, SlitThatIsNoLine) {
  EXPECT_THAT([] { read_text(Communicator(), good, {"water"}); },
              testing::ThrowsMessage<MeshError>(
                  "the region 'water' cannot be a slit, since it is no line region"));
  EXPECT_THAT(
      [] { read_text(Communicator(), good, {"cable"}); },
      testing::ThrowsMessage<MeshError>("the mesh has no region 'cable'; it has wall, water"));
}

/// A name that a geometry's author left without a curve is no reason to refuse the mesh.
TEST(EmptyGroup, IsLeftOutWithANote) {
  auto text = good;
  text.replace(text.find("2\n1 1 \"wall\""), 1, "3\n1 7 \"nothing\"");
  const Mesh mesh = read_text(Communicator(), text);
  EXPECT_EQ(mesh.regions.size(), 2U);
  if (mesh.communicator.rank() == 0) {
    EXPECT_THAT(mesh.notes, testing::Contains("physical group 'nothing' of the mesh file has no "
                                              "elements and is left out"));
  }
}

}  // namespace
}  // namespace hawser
