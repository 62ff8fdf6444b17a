// The audit must not be felt beside the reading of a mesh: below 2 s for a million cells.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>

#include "hawser/mesh/mesh_audit.hpp"
#include "src/whole_mesh.hpp"

namespace hawser {
namespace {

/// n by n unit squares of two triangles each, whole, with a wall around it and the domain of one
/// module.
Mesh squares(int n) {
  Mesh mesh;
  const auto id = [n](int i, int j) { return static_cast<LocalIndex>(i + (n + 1) * j); };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      mesh.vertices.ids.push_back(id(i, j));
      mesh.coordinates.insert(mesh.coordinates.end(), {double(i), double(j)});
    }
  mesh.vertices.global_count = mesh.vertices.size();
  Region water = make_region("water", CellShape::triangle),
         wall = make_region("wall", CellShape::line);
  const auto add = [](Region& region, std::initializer_list<LocalIndex> cell) {
    region.cell_ids.push_back(region.size());
    region.vertices.insert(region.vertices.end(), cell);
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      add(water, {id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      add(water, {id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  for (int i = 0; i < n; ++i) {
    add(wall, {id(i, 0), id(i + 1, 0)});
    add(wall, {id(i, n), id(i + 1, n)});
    add(wall, {id(0, i), id(0, i + 1)});
    add(wall, {id(n, i), id(n, i + 1)});
  }
  mesh.regions = {water, wall};
  return mesh;
}

TEST(AuditSpeed, AMillionCellsTakeLessThanTwoSeconds) {
  MeshOptions options;
  options.domains = {Domain("water")};
  Mesh mesh = squares(708);
  add_topology(mesh, options);
  ASSERT_GT(mesh.body.size(), 1000000);
  const auto start = std::chrono::steady_clock::now();
  const auto findings = audit(mesh, options);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::cout << "audit of " << mesh.body.size() << " cells: " << seconds << " s\n";
  EXPECT_TRUE(findings.empty());
  EXPECT_LT(seconds, 2);
}

// Two halves that share no node: every step of the audit has work to do.
TEST(AuditSpeed, ADoubledInterfaceIsFoundInTheSameTime) {
  MeshOptions options;
  Mesh mesh = squares(708), other = squares(708);
  const LocalIndex shift = mesh.vertices.size();
  for (LocalIndex v = 0; v < shift; ++v) {
    mesh.vertices.ids.push_back(shift + v);
    mesh.coordinates.insert(mesh.coordinates.end(),
                            {other.coordinates[at(2 * v)] + 708, other.coordinates[at(2 * v + 1)]});
  }
  mesh.vertices.global_count = mesh.vertices.size();
  for (const auto v : other.regions[0].vertices)
    mesh.regions[0].vertices.push_back(v + shift);
  for (LocalIndex c = 0; c < other.regions[0].size(); ++c)
    mesh.regions[0].cell_ids.push_back(mesh.regions[0].size());
  add_topology(mesh, options);
  const auto start = std::chrono::steady_clock::now();
  const auto findings = audit(mesh, options);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::cout << "audit of " << mesh.body.size() << " cells in two parts: " << seconds << " s\n";
  ASSERT_FALSE(findings.empty());
  EXPECT_NE(findings[0].sentence.find("709 places"), std::string::npos) << findings[0].sentence;
  EXPECT_LT(seconds, 4);
}

}  // namespace
}  // namespace hawser
