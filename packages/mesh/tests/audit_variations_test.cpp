// Every kind of fault of a mesh in ten forms: other cells, sizes, places and directions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

/// How the n-th mesh is: a grid of unit squares, moved and turned.
struct Form {
  int nx, ny;
  double size, angle;

  /// Grids of 3 by 2 to 12 by 4 squares, from 1 mm to 100 km, in all directions.
  explicit Form(int n)
      : nx(3 + n), ny(2 + n % 3), size(std::pow(10.0, n % 9 - 3)), angle(0.7 * n) {}

  MeshText placed(MeshText mesh) const {
    for (auto& [x, y] : mesh.nodes) {
      const double u = size * (x * std::cos(angle) - y * std::sin(angle)) + 3 * size;
      y = size * (x * std::sin(angle) + y * std::cos(angle)) - 7 * size;
      x = u;
    }
    return mesh;
  }
  MeshText box() const { return grid(nx, ny); }
  int vertex(int i, int j) const { return i + (nx + 1) * j; }
};

int add_node(MeshText& mesh, double x, double y) {
  mesh.nodes.push_back({x, y});
  return static_cast<int>(mesh.nodes.size()) - 1;
}

/// On rank 0; none elsewhere.
std::vector<std::string> notes(const MeshText& text, const std::vector<Domain>& domains = {}) {
  const auto mesh = read_text(Communicator(), text.in_format("2.2"), {}, domains);
  return mesh.communicator.is_root() ? mesh.notes : std::vector<std::string>();
}

class Variations : public testing::TestWithParam<int> {
 protected:
  /// A sentence among the notes, on rank 0.
  static void expect_note(const MeshText& text, const std::string& sentence,
                          const std::vector<Domain>& domains = {}) {
    const auto told = notes(text, domains);
    if (Communicator().is_root()) {
      EXPECT_THAT(told, Contains(HasSubstr(sentence)));
    }
  }
  static void expect_refusal(const MeshText& text, const std::string& sentence,
                             const std::vector<Domain>& domains = {}) {
    EXPECT_THAT([&] { notes(text, domains); }, ThrowsMessage<MeshError>(HasSubstr(sentence)));
  }

  const int n = GetParam();
  const Form form{n};
};

INSTANTIATE_TEST_SUITE_P(Ten, Variations, testing::Range(0, 10));

TEST_P(Variations, AGoodMeshHasNoNotes) {
  EXPECT_THAT(notes(form.placed(form.box()), {Domain("water")}), IsEmpty());
}

TEST_P(Variations, PartsWithAGapBetweenThem) {
  MeshText mesh = form.box();
  const MeshText other = form.box();
  const int shift = static_cast<int>(mesh.nodes.size());
  for (const auto& node : other.nodes)
    mesh.nodes.push_back({node[0] + form.nx + 0.05 + 0.3 * n, node[1] + 0.1 * n});
  for (std::size_t g = 0; g < 2; ++g)
    for (auto cell : other.groups[g].cells) {
      for (int& v : cell)
        v += shift;
      mesh.groups[g].cells.push_back(cell);
    }
  expect_note(form.placed(mesh), "the body is in 2 parts that share no edge: " +
                                     std::to_string(2 * form.nx * form.ny) + " cells from (");
}

TEST_P(Variations, CellsInNoModule) {
  MeshText mesh = form.box();
  mesh.groups.push_back({"hull", 2, {}});
  auto& water = mesh.groups[0].cells;
  for (int k = 0; k <= n; ++k, water.pop_back())
    mesh.groups[2].cells.push_back(water.back());
  expect_note(form.placed(mesh),
              std::to_string(n + 1) + (n == 0 ? " cell" : " cells") + " of the body's " +
                  std::to_string(2 * form.nx * form.ny) + ", of 'hull', belong to no module",
              {Domain("water")});
}

TEST_P(Variations, PointsOfNoCell) {
  MeshText mesh = form.box();
  MeshText::Group pins{"pins", 0, {}};
  for (int k = 0; k <= n; ++k)
    pins.cells.push_back({add_node(mesh, 0.3 + k % form.nx, 0.1 + 0.05 * k)});
  mesh.groups.push_back(pins);
  expect_note(form.placed(mesh), std::to_string(n + 1) + (n == 0 ? " node" : " nodes") +
                                     " of 'pins' belong" + (n == 0 ? "s" : "") +
                                     " to no line and no cell, at (");
}

TEST_P(Variations, NodesOfNoElement) {
  MeshText mesh = form.box();
  for (int k = 0; k <= n; ++k)
    add_node(mesh, k, -1.0 - n);
  expect_note(form.placed(mesh), std::to_string(n + 1) + (n == 0 ? " node" : " nodes") +
                                     " of the mesh file in no element");
}

TEST_P(Variations, CellsThatAreNearlyFlat) {
  MeshText mesh = form.box();
  mesh.nodes[static_cast<std::size_t>(form.vertex(1, 1))] = {1, std::pow(10.0, -4 - 0.4 * n)};
  expect_note(form.placed(mesh), "nearly flat, of quality ");
}

TEST_P(Variations, CellsThatAreFlat) {
  MeshText mesh = form.box();
  const int j = n % form.ny;
  mesh.groups[0].cells[static_cast<std::size_t>(n)] = {
      form.vertex(n % 2, j), form.vertex(1 + n % 2, j), form.vertex(2 + n % 2, j)};
  expect_refusal(form.placed(mesh), " of 'water' is flat or folded over");
}

TEST_P(Variations, CellsThatAreTangled) {
  // An inner node is pulled beyond its neighbours: their cells turn over or lie over each other.
  MeshText mesh = form.box();
  mesh.nodes[static_cast<std::size_t>(form.vertex(1 + n % (form.nx - 1), 1))] = {form.nx + 0.5 + n,
                                                                                 form.ny + 1.3};
  EXPECT_THROW(notes(form.placed(mesh)), MeshError);
}

TEST_P(Variations, RegionsOfTheSameCellsAreNoFault) {
  MeshText mesh = form.box();
  for (int k = 0; k <= n; ++k) {
    mesh.groups.push_back(mesh.groups[static_cast<std::size_t>(k % 2)]);
    mesh.groups.back().name = "again " + std::to_string(k);
  }
  const auto read = read_text(Communicator(), form.placed(mesh).in_format("4.1"));
  EXPECT_THAT(read.notes, IsEmpty());
  long long mine = 0;
  for (const int owner : read.body.cell_owners)
    mine += owner == read.communicator.rank() ? 1 : 0;
  EXPECT_EQ(read.communicator.sum(mine), 2 * form.nx * form.ny);
}

TEST_P(Variations, RegionsThatOverlapAreNoFault) {
  MeshText mesh = form.box();
  MeshText::Group some{"some", 2, {}};
  for (int k = 0; k <= n; ++k)
    some.cells.push_back(mesh.groups[0].cells[static_cast<std::size_t>(k)]);
  mesh.groups.push_back(some);
  const auto read = read_text(Communicator(), form.placed(mesh).in_format("2.2"));
  EXPECT_THAT(read.notes, IsEmpty());
  EXPECT_EQ(count_cells(read, "some"), n + 1);
}

TEST_P(Variations, AnOutflowPartlyInside) {
  MeshText mesh = form.box();
  std::vector<int> way;
  for (int i = 0; i <= 1 + n % (form.nx - 2); ++i)
    way.push_back(form.vertex(i, 0));
  const auto outside = way.size() - 1;
  way.push_back(form.vertex(static_cast<int>(outside), 1));
  mesh.groups.push_back(line("outflow", way));
  expect_refusal(form.placed(mesh),
                 "1 of the " + std::to_string(outside + 1) +
                     " edges of 'outflow' are not on the boundary but inside the body",
                 {Domain("water"), Domain::facets("outflow")});
}

TEST_P(Variations, EdgesWithoutLength) {
  MeshText mesh;
  std::vector<int> way;
  for (int k = 0; k < 12; ++k)
    way.push_back(add_node(mesh, k <= n ? k : k - 1, 0.2 * (k <= n ? k : k - 1)));
  mesh.groups = {line("cable", way)};
  expect_refusal(form.placed(mesh), "1 edge of 'cable' has no length, at (");
}

TEST_P(Variations, ACableThatLeavesTheWater) {
  MeshText mesh = form.box();
  std::vector<int> way;
  for (int j = 0; j <= form.ny; ++j)
    way.push_back(form.vertex(1, j));
  for (int k = 0; k <= n; ++k)
    way.push_back(add_node(mesh, 1 + 0.1 * k, form.ny + 1.0 + k));
  mesh.groups.push_back(line("cable", way));
  expect_refusal(form.placed(mesh),
                 std::to_string(n + 1) + " of the " + std::to_string(way.size() - 1) +
                     " edges of 'cable' belong" + (n == 0 ? "s" : "") + " to no cell of the body",
                 {Domain("water"), Domain("cable")});
}

TEST_P(Variations, ALineThatNobodyUses) {
  MeshText mesh = form.box();
  std::vector<int> way;
  for (int k = 0; k <= n + 1; ++k)
    way.push_back(add_node(mesh, 0.25 + 0.1 * k, 0.45));
  mesh.groups.push_back(line("seam", way));
  const std::string count = std::to_string(n + 1);
  expect_note(form.placed(mesh),
              count + " of the " + count + (n == 0 ? " edge" : " edges") + " of 'seam' belong",
              {Domain("water")});
}

TEST_P(Variations, LinesThatMeetInNodesOfTheirOwn) {
  MeshText mesh;
  for (int piece = 0; piece <= n + 1; ++piece)
    mesh.groups.push_back(line("piece " + std::to_string(piece),
                               {add_node(mesh, piece, 0), add_node(mesh, piece + 1, 0)}));
  expect_refusal(form.placed(mesh), "several nodes at one place, at " + std::to_string(n + 1) +
                                        (n == 0 ? " place" : " places") + ": at (");
}

TEST_P(Variations, ABoundaryThatIsNamedNowhere) {
  MeshText mesh = form.box();
  mesh.groups.pop_back();
  expect_note(form.placed(mesh), std::to_string(2 * (form.nx + form.ny)) +
                                     " edges of the body's boundary are in no region: a ring");
}

TEST_P(Variations, PartsOverEachOther) {
  MeshText mesh = form.box();
  const MeshText other = form.box();
  const int shift = static_cast<int>(mesh.nodes.size());
  for (const auto& node : other.nodes)
    mesh.nodes.push_back({node[0] + 0.31 + 0.21 * n, node[1] + 0.37});
  for (std::size_t g = 0; g < 2; ++g)
    for (auto cell : other.groups[g].cells) {
      for (int& v : cell)
        v += shift;
      mesh.groups[g].cells.push_back(cell);
    }
  expect_refusal(form.placed(mesh), "parts of the body lie over each other: ");
}

TEST_P(Variations, ASlitBesideTheBody) {
  MeshText mesh = form.box();
  std::vector<int> way;
  for (int k = 0; k <= n + 1; ++k)
    way.push_back(add_node(mesh, 1.1 + 0.15 * k, 0.7));
  mesh.groups.push_back(line("slit", way));
  EXPECT_THAT([&] { read_text(Communicator(), form.placed(mesh).in_format("4.1"), {"slit"}); },
              ThrowsMessage<MeshError>(HasSubstr(" of 'slit' belong")));
}

}  // namespace
}  // namespace hawser
