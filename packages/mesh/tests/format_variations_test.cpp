// Every kind of MSH file in ten forms: binary, partitioned, without names, of elements that are
// not read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "binary_mesh.hpp"
#include "hawser/base/error.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

void expect_same(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.coordinates, b.coordinates);
  EXPECT_EQ(a.body.vertices, b.body.vertices);
  ASSERT_EQ(a.regions.size(), b.regions.size());
  for (std::size_t r = 0; r < a.regions.size(); ++r)
    EXPECT_EQ(a.regions[r].vertices, b.regions[r].vertices);
}

class Files : public testing::TestWithParam<int> {
 protected:
  const int n = GetParam();
};
INSTANTIATE_TEST_SUITE_P(Ten, Files, testing::Range(0, 10));

/// With a line inside and a point.
MeshText sample(int n) {
  MeshText text = grid(2 + n, 1 + n % 4);
  text.groups.push_back({"corners", 0, {{0}, {2 + n}}});
  text.groups.push_back(line("seam", {0, 1, 2}));
  return text;
}

TEST_P(Files, BinaryAreReadAsText) {
  const Communicator world;
  const auto as_text = read_text(world, sample(n).in_format("4.1"));
  expect_same(as_text, read_text(world, sample(n).in_format("2.2")));
  expect_same(as_text, read_text(world, binary(sample(n), "4.1")));
  expect_same(as_text, read_text(world, binary(sample(n), "2.2")));
}

TEST_P(Files, CutShortAreRefused) {
  for (const std::string& whole : {binary(sample(0), "4.1"), binary(sample(0), "2.2"),
                                   sample(0).in_format("4.1"), sample(0).in_format("2.2")}) {
    const std::size_t size = (whole.size() - 20) * static_cast<std::size_t>(n) / 10;
    EXPECT_THAT([&] { read_text(Communicator(), whole.substr(0, size)); },
                ThrowsMessage<MeshError>(testing::StartsWith("test.msh:")));
  }
}

/// As gmsh -part writes it: the triangles in pieces of their entity, which are entities, too.
std::string partitioned(int squares, int parts) {
  const MeshText mesh = grid(squares, 1);
  const auto& cells = mesh.groups[0].cells;
  std::string text = mesh.in_format("4.1");
  std::string pieces = "$PartitionedEntities\n" + std::to_string(parts) + "\n0\n0 0 " +
                       std::to_string(parts) + " 0\n";
  std::string blocks;
  std::size_t next = 0;
  for (int p = 1; p <= parts; ++p) {
    const auto number = std::to_string(100 + p);
    pieces += number + " 2 1 1 " + std::to_string(p) + " 0 0 0 1 1 0 0 0\n";
    const std::size_t end = cells.size() * static_cast<std::size_t>(p) / std::size_t(parts);
    blocks += "2 " + number + " 2 " + std::to_string(end - next) + "\n";
    for (; next < end; ++next) {
      blocks += std::to_string(next + 1);
      for (const int v : cells[next])
        blocks += " " + std::to_string(v + 1);
      blocks += "\n";
    }
  }
  pieces += "$EndPartitionedEntities\n";
  text.insert(text.find("$Nodes"), pieces);
  // The block of all triangles gives way to those of the pieces, the one of lines stays.
  const std::string header = "$Elements\n2 ";
  text.replace(text.find(header), header.size(), "$Elements\n" + std::to_string(parts + 1) + " ");
  const auto first = text.find("\n2 1 2 ") + 1, last = text.find("\n1 2 1 ", first) + 1;
  return text.replace(first, last - first, blocks);
}

TEST_P(Files, PartitionedAreReadAsWhole) {
  const Communicator world;
  const int squares = 6 + n, parts = 2 + n;
  expect_same(read_text(world, grid(squares, 1).in_format("4.1")),
              read_text(world, partitioned(squares, parts)));
}

TEST_P(Files, PartsOfAPartitionedMeshAreRefused) {
  std::string text = partitioned(6 + n, 2 + n);
  const std::string there = "$PartitionedEntities\n" + std::to_string(2 + n);
  text.replace(text.find(there), there.size(),
               "$PartitionedEntities\n" + std::to_string(3 + 2 * n));
  EXPECT_THAT([&] { read_text(Communicator(), text); },
              ThrowsMessage<MeshError>(HasSubstr("holds " + std::to_string(2 + n) + " of the " +
                                                 std::to_string(3 + 2 * n) +
                                                 " parts of a partitioned mesh")));
}

/// A number of gmsh's type and of its nodes, and what is said of it.
struct Type {
  int type, nodes;
  std::string words;
};
void PrintTo(const Type& type, std::ostream* out) { *out << type.type; }

class RefusedTypes : public testing::TestWithParam<Type> {};

TEST_P(RefusedTypes, AreNamedWithWhatToDo) {
  const auto& [type, nodes, words] = GetParam();
  std::string element = "1 " + std::to_string(type) + " 2 1 1";
  for (int k = 0; k < nodes; ++k)
    element += " " + std::to_string(1 + k % 4);
  std::string text = grid(1, 1).in_format("2.2");
  const auto at = text.find("1 2 2 1 1 ");
  text.replace(at, text.find('\n', at) - at, element);
  EXPECT_THAT([&] { read_text(Communicator(), text); },
              ThrowsMessage<MeshError>(testing::AllOf(
                  testing::StartsWith("test.msh:18: element 1 is "), HasSubstr(words),
                  HasSubstr("only points, lines and triangles of first order are read: "))));
}

INSTANTIATE_TEST_SUITE_P(
    Ten, RefusedTypes,
    testing::Values(Type{3, 4, "a quadrilateral"}, Type{4, 4, "a tetrahedron"},
                    Type{5, 8, "of gmsh's type 5"}, Type{6, 6, "of gmsh's type 6"},
                    Type{8, 3, "a line of higher order"}, Type{9, 6, "a triangle of higher order"},
                    Type{10, 9, "a quadrilateral"}, Type{11, 10, "of gmsh's type 11"},
                    Type{16, 8, "a quadrilateral"}, Type{21, 10, "a triangle of higher order"},
                    Type{26, 4, "a line of higher order"}, Type{92, 64, "of gmsh's type 92"}));

TEST_P(Files, GroupsWithoutNamesAreCalledByTheirNumbers) {
  // Of five lines beside each other those have names whose bit is set in 3 n.
  const auto has_name = [&](int k) { return ((3 * n) >> k & 1) != 0; };
  MeshText mesh;
  for (int k = 0; k <= 5; ++k)
    mesh.nodes.push_back({double(k), 0.1 * k});
  for (int k = 0; k < 5; ++k)
    mesh.groups.push_back(line("line " + std::to_string(k), {k, k + 1}));
  std::string text = mesh.in_format("2.2");
  std::string names;
  int named = 0;
  for (int k = 0; k < 5; ++k)
    if (has_name(k)) {
      names += "1 " + std::to_string(k + 1) + " \"line " + std::to_string(k) + "\"\n";
      ++named;
    }
  const auto begin = text.find("$PhysicalNames"), end = text.find("$Nodes");
  text.replace(begin, end - begin,
               "$PhysicalNames\n" + std::to_string(named) + "\n" + names + "$EndPhysicalNames\n");
  const auto read = read_text(Communicator(), text);
  for (int k = 0; k < 5; ++k)
    EXPECT_EQ(count_cells(read, has_name(k) ? "line " + std::to_string(k) : std::to_string(k + 1)),
              1);
  EXPECT_EQ(read.regions.size(), 5u);
  EXPECT_THAT(read.notes, IsEmpty());
}

}  // namespace
}  // namespace hawser
