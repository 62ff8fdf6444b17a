#include "hawser/fields/dof_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "hawser/base/error.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

constexpr int nx = 6, ny = 4;

/// A slit along y = 2 from x = 1 to x = 5: three interior vertices, doubled for a split field.
Mesh slit_mesh() {
  MeshText text = grid(nx, ny);
  const int row = 2 * (nx + 1);
  text.groups.push_back(line("cable", {row + 1, row + 2, row + 3, row + 4, row + 5}));
  return read_text(Communicator(), text.in_format("4.1"), {"cable"});
}

std::vector<FieldDescription> fields() {
  return {{"velocity", "m/s", "N/m", 2, Basis::p2, Numbering::continuous, {"water"}},
          {"pressure", "Pa", "m^2/s", 1, Basis::p1, Numbering::sides, {"water"}},
          {"tension", "N", "m", 1, Basis::p1, Numbering::continuous, {"cable"}}};
}

/// What all ranks say, one after the other.
std::vector<GlobalIndex> gathered(const Communicator& all, const std::vector<GlobalIndex>& mine) {
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(all.size())), starts(counts.size(), 0);
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, all.mpi());
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  std::vector<GlobalIndex> result(static_cast<std::size_t>(starts.back() + counts.back()));
  MPI_Allgatherv(mine.data(), count, MPI_LONG_LONG, result.data(), counts.data(), starts.data(),
                 MPI_LONG_LONG, all.mpi());
  return result;
}

TEST(DofMap, CountsEveryFieldWhereItLives) {
  const Mesh mesh = slit_mesh();
  const DofMap dofs(mesh, fields());
  const GlobalIndex vertices = (nx + 1) * (ny + 1);
  const GlobalIndex edges = nx * (ny + 1) + (nx + 1) * ny + nx * ny;
  EXPECT_EQ(dofs.global_count(), 2 * (vertices + edges) + (vertices + 3) + 5);
}

TEST(DofMap, GlobalRowsOfAllRanksAreAPermutation) {
  const Mesh mesh = slit_mesh();
  const DofMap dofs(mesh, fields());
  const auto& rows = dofs.global_rows();
  auto all = gathered(mesh.communicator, {rows.begin(), rows.begin() + dofs.owned()});
  std::sort(all.begin(), all.end());
  std::vector<GlobalIndex> counted(static_cast<std::size_t>(dofs.global_count()));
  std::iota(counted.begin(), counted.end(), 0);
  EXPECT_EQ(all, counted);
}

TEST(DofMap, GhostsHaveTheRowsOfTheirOwners) {
  const Mesh mesh = slit_mesh();
  const DofMap dofs(mesh, fields());
  std::vector<GlobalIndex> mine;
  for (LocalIndex row = 0; row < dofs.rows(); ++row) {
    const RowInfo& info = dofs.info(row);
    mine.insert(mine.end(),
                {info.field, info.component, static_cast<GlobalIndex>(info.kind),
                 dofs.point_id(row), dofs.global_rows()[static_cast<std::size_t>(row)]});
  }
  const auto all = gathered(mesh.communicator, mine);
  std::map<std::array<GlobalIndex, 4>, GlobalIndex> row_of;
  for (std::size_t i = 0; i < all.size(); i += 5) {
    const auto known = row_of.emplace(
        std::array<GlobalIndex, 4>{all[i], all[i + 1], all[i + 2], all[i + 3]}, all[i + 4]);
    EXPECT_EQ(known.first->second, all[i + 4]);
  }
  EXPECT_EQ(static_cast<GlobalIndex>(row_of.size()), dofs.global_count());
  EXPECT_EQ(dofs.rows() > dofs.owned(), mesh.communicator.size() > 1) << "ghosts";
}

TEST(DofMap, RowsOfACellAreThoseOfItsVerticesThenOfItsEdges) {
  const Mesh mesh = slit_mesh();
  const DofMap dofs(mesh, fields());
  const Region& water = mesh.region("water");
  for (LocalIndex cell = 0; cell < water.size(); ++cell) {
    std::vector<LocalIndex> rows;
    dofs.append_cell_rows(dofs.find("velocity"), water, cell, rows);
    ASSERT_EQ(static_cast<int>(rows.size()), dofs.nodes_per_cell(0, water));
    double x[6][2];
    for (std::size_t a = 0; a < 6; ++a) {
      ASSERT_GE(rows[a], 0);
      dofs.position(rows[a], x[a]);
    }
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 2; ++j)
        EXPECT_EQ(x[3 + k][j], 0.5 * (x[k][j] + x[(k + 1) % 3][j]));
  }
}

TEST(DofMap, ASplitFieldHasARowOnEachSideOfALine) {
  const Mesh mesh = slit_mesh();
  const DofMap dofs(mesh, fields());
  const auto owned_on_cable = [&](const char* field) {
    const auto rows = dofs.region_rows(dofs.find(field), mesh.region("cable"));
    return mesh.communicator.sum(static_cast<long long>(
        std::count_if(rows.begin(), rows.end(), [&](LocalIndex r) { return r < dofs.owned(); })));
  };
  EXPECT_EQ(owned_on_cable("pressure"), 5 + 3);
  EXPECT_EQ(owned_on_cable("velocity"), 5 + 4);
  EXPECT_EQ(owned_on_cable("tension"), 5);
}

// An edge of a slit would need a node on either side.
TEST(DofMap, AQuadraticFieldIsNotDoubledAcrossASlit) {
  const Mesh slit = slit_mesh();
  const std::vector<FieldDescription> by_sides = {
      {"pressure", "Pa", "m^2/s", 1, Basis::p2, Numbering::sides, {"water"}}};
  EXPECT_THAT(
      [&] { const DofMap dofs(slit, by_sides); },
      testing::ThrowsMessage<DeckError>(testing::HasSubstr("'pressure' is numbered by the sides")));
  const Mesh whole = read_text(Communicator(), grid(nx, ny).in_format("4.1"));
  const DofMap dofs(whole, by_sides);
  EXPECT_EQ(dofs.global_count(), (2 * nx + 1) * (2 * ny + 1));
}

}  // namespace
}  // namespace hawser
