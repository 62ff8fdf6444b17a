// The same mesh in whatever form gmsh writes it is the same mesh.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "binary_mesh.hpp"
#include "hawser/base/error.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

void expect_same(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.coordinates, b.coordinates);
  EXPECT_EQ(a.body.vertices, b.body.vertices);
  ASSERT_EQ(a.regions.size(), b.regions.size());
  for (std::size_t r = 0; r < a.regions.size(); ++r) {
    EXPECT_EQ(a.regions[r].name, b.regions[r].name);
    EXPECT_EQ(a.regions[r].vertices, b.regions[r].vertices);
  }
}

MeshText sample() {
  MeshText text = grid(3, 2);
  text.groups.push_back({"corner", 0, {{0}}});
  return text;
}

TEST(Formats, BinaryIsReadAsText) {
  const Communicator world;
  const auto text = sample();
  const auto as_text = read_text(world, text.in_format("4.1"));
  expect_same(as_text, read_text(world, binary(text, "4.1")));
  expect_same(as_text, read_text(world, binary(text, "2.2")));
}

TEST(Formats, ABinaryFileCutAnywhereIsRefused) {
  const std::string whole = binary(sample(), "4.1");
  int refused = 0;
  for (std::size_t size = 0; size + 14 < whole.size(); size += 7, ++refused)
    EXPECT_THROW(read_text(Communicator(), whole.substr(0, size)), MeshError) << size;
  EXPECT_GT(refused, 50);
}

TEST(Formats, BytesOfAnotherOrderAreRefused) {
  std::string text = binary(sample(), "4.1");
  const auto one = text.find("8\n") + 2;
  std::swap(text[one], text[one + 3]);
  EXPECT_THAT([&] { read_text(Communicator(), text); },
              ThrowsMessage<MeshError>(HasSubstr("of the other byte order; write it as ASCII")));
}

// As gmsh -part 2 writes it: the elements' entities are pieces, the parts' boundary is one more.
const std::string partitioned = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "wall"
2 2 "water"
$EndPhysicalNames
$Entities
0 1 1 0
1 0 0 0 1 0 0 1 1 0
1 0 0 0 1 1 0 1 2 0
$EndEntities
$PartitionedEntities
2
1
9 1
0 2 2 0
2 1 1 1 1 0 0 0 1 0 0 1 1 0
3 2 1 2 1 2 0 0 0 1 1 0 1 2 0
2 2 1 1 1 0 0 0 1 1 0 1 2 0
3 2 1 1 2 0 0 0 1 1 0 GROUPS
$EndPartitionedEntities
$Nodes
1 4 1 4
2 2 0 4
1
2
3
4
0 0 0
1 0 0
1 1 0
0 1 0
$EndNodes
$Elements
4 4 1 4
1 2 1 1
1 1 2
1 3 1 1
2 1 3
2 2 2 1
3 1 2 3
2 3 2 1
4 1 3 4
$EndElements
$GhostElements
1
4 2 1 1
$EndGhostElements
)";

std::string with(const std::string& what, const std::string& instead) {
  std::string text = partitioned;
  return text.replace(text.find(what), what.size(), instead);
}

TEST(Formats, PartsOfAPartitionedMeshAreForgotten) {
  MeshText whole;
  whole.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  whole.groups = {{"wall", 1, {{0, 1}}}, {"water", 2, {{0, 1, 2}, {0, 2, 3}}}};
  const auto expected = read_text(Communicator(), whole.in_format("4.1"));
  // A piece has the groups of the entity whose piece it is, whether it repeats them or not.
  expect_same(expected, read_text(Communicator(), with("GROUPS", "1 2 0")));
  expect_same(expected, read_text(Communicator(), with("GROUPS", "0 0")));
}

TEST(Formats, APartOfAMeshIsRefused) {
  std::string text = with("GROUPS", "0 0");
  text.replace(text.find("$PartitionedEntities\n2"), 22, "$PartitionedEntities\n3");
  EXPECT_THAT([&] { read_text(Communicator(), text); },
              ThrowsMessage<MeshError>(HasSubstr("holds 2 of the 3 parts of a partitioned mesh; "
                                                 "write all parts into one file")));
}

std::vector<std::string> names(const Mesh& mesh) {
  std::vector<std::string> result;
  for (const auto& region : mesh.regions)
    result.push_back(region.name);
  return result;
}

/// The mesh with these lines of $PhysicalNames alone; the groups have the numbers 1, 2, 3.
Mesh named(const std::vector<std::string>& lines) {
  std::string text = sample().in_format("2.2");
  const auto begin = text.find("$PhysicalNames"), end = text.find("$Nodes");
  std::string names;
  if (!lines.empty()) {
    names = "$PhysicalNames\n" + std::to_string(lines.size()) + "\n";
    for (const auto& line : lines)
      names += line + "\n";
    names += "$EndPhysicalNames\n";
  }
  return read_text(Communicator(), text.replace(begin, end - begin, names));
}

TEST(Formats, GroupsWithoutANameAreCalledByTheirNumber) {
  EXPECT_THAT(names(named({})), ElementsAre("1", "2", "3"));
  EXPECT_THAT(names(named({"1 2 \"wall\""})), ElementsAre("wall", "1", "3"));
  EXPECT_THAT(names(named({"1 2 \"1\""})), ElementsAre("1", "surface_1", "3"));
  EXPECT_THAT(names(named({"1 2 \"3\""})), ElementsAre("3", "1", "point_3"));
}

TEST(Formats, TheSameNumberOfTwoDimensionsIsToldApart) {
  std::string text = sample().in_format("2.2");
  const auto begin = text.find("$PhysicalNames"), end = text.find("$Nodes");
  text.replace(begin, end - begin, "");
  for (std::size_t at = text.find(" 1 2 2 2 "); at != std::string::npos;
       at = text.find(" 1 2 2 2 "))
    text.replace(at, 9, " 1 2 1 2 ");
  EXPECT_THAT(names(read_text(Communicator(), text)), ElementsAre("surface_1", "curve_1", "3"));
}

TEST(Formats, TrianglesOfNoGroupAreNoted) {
  std::string text = sample().in_format("2.2");
  const auto first = text.find("1 2 2 1 1 ");
  text.replace(first, 10, "1 2 2 0 1 ");
  const auto mesh = read_text(Communicator(), text);
  EXPECT_THAT(mesh.notes,
              testing::Contains(HasSubstr("1 triangle of the mesh file in no physical group")));
}

}  // namespace
}  // namespace hawser
