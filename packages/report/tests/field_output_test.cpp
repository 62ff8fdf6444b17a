// Lines as grids of their own, with what their modules and reports have to tell.
#include "hawser/report/field_output.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hawser/report/line_geometry.hpp"
#include "output/src/hdf5_file.hpp"
#include "report_sample.hpp"

namespace hawser {
namespace {

/// A module that tells the x of the middle of each of its segments.
class MiddleKernel : public LoadKernel {
 public:
  explicit MiddleKernel(const std::string& region)
      : LoadKernel(region, CellShape::line, {velocity(Role::adds), displacement(Role::adds)}) {}
  std::vector<Quantity> quantities() const override { return {{"middle", "m"}}; }
  void evaluate(const CellInput& cell, double* values) const override {
    values[0] = (cell.coordinates[0] + cell.coordinates[2]) / 2;
  }
};

std::vector<double> numbers(const std::string& file, const std::string& name) {
  const Hdf5File grid = Hdf5File::open(Communicator(), file);
  std::vector<GlobalIndex> all;
  for (GlobalIndex i = 0; i < grid.shape(name).rows; ++i)
    all.push_back(i);
  return grid.read(name, all);
}

TEST(FieldOutput, WritesABranchedLineAndOneApartByTheirOwnCells) {
  MeshText text = grid(4, 2);  // (i, j) is vertex i + 5 j
  text.groups.push_back(line("tree", {5, 6, 7}));
  text.groups.back().cells.push_back({6, 11});
  text.groups.push_back(line("flow", {8, 9}));
  text.groups.push_back(line("nobody", {3, 8}));
  const Mesh mesh = read_text(Communicator(), text.in_format("4.1"));
  std::vector<PhysicsModule> modules;
  modules.push_back(module_with("tree", std::make_unique<MiddleKernel>("tree")));
  modules.push_back(module_with("twig", std::make_unique<MiddleKernel>("flow")));
  const FieldTable table = gather_fields(modules);
  const DofMap dofs(mesh, table.fields);
  const Assembler assembler(dofs, modules);
  State state;
  for (std::vector<double>* values :
       {&state.value, &state.rate, &state.accepted, &state.rate_slope, &state.rate_partner})
    values->assign(static_cast<std::size_t>(dofs.rows()), 0.25);
  const std::vector<std::unique_ptr<Report>> none;
  FieldOutput output(assembler, modules, none, ".", -1);
  EXPECT_TRUE(output.writes());
  output.write(3, state);

  // Vertices 5, 6, 7 and 11, in this order: at the branch the mean of three segments.
  const std::vector<double> expected = {0.5, (0.5 + 1.5 + 1) / 3, 1.5, 1};
  EXPECT_EQ(numbers("tree-000003.h5", "fields/middle"), expected);
  EXPECT_EQ(numbers("tree-000003.h5", "points"),
            (std::vector<double>{0.25, 1.25, 0, 1.25, 1.25, 0, 2.25, 1.25, 0, 1.25, 2.25, 0}));
  EXPECT_EQ(numbers("tree-000003.h5", "cells").size(), 6U);
  // The body's files are called flow.
  EXPECT_EQ(numbers("flow_line-000003.h5", "fields/middle"), (std::vector<double>{3.5, 3.5}));
  EXPECT_EQ(numbers("flow-000003.h5", "cells").size(), 48U);
  const Hdf5File tree = Hdf5File::open(Communicator(), "tree-000003.h5");
  EXPECT_EQ(tree.names("fields"), (std::vector<std::string>{"middle", "velocity"}));
}

/// Tells the x of a corner of each of its triangles.
class CornerKernel : public LoadKernel {
 public:
  explicit CornerKernel(const std::string& region)
      : LoadKernel(region, CellShape::triangle, {velocity(Role::adds), displacement(Role::adds)}) {}
  std::vector<Quantity> quantities() const override { return {{"corner", "m"}}; }
  void evaluate(const CellInput& cell, double* values) const override {
    values[0] = cell.coordinates[0];
  }
};

TEST(FieldOutput, WritesWhatTheKernelsTellOfTheCellsOfABody) {
  MeshText text = grid(2, 1);  // cells (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4)
  text.groups.push_back({"left", 2, {{0, 1, 4}, {0, 4, 3}}});
  const Mesh mesh = read_text(Communicator(), text.in_format("4.1"));
  std::vector<PhysicsModule> modules;
  modules.push_back(module_with("solid", std::make_unique<CornerKernel>("left")));
  modules.push_back(module_with(
      "flow", std::make_unique<LoadKernel>(
                  "water", CellShape::triangle,
                  std::vector<FieldUse>{velocity(Role::adds), displacement(Role::adds)})));
  const FieldTable table = gather_fields(modules);
  const DofMap dofs(mesh, table.fields);
  const Assembler assembler(dofs, modules);
  State state;
  for (std::vector<double>* values :
       {&state.value, &state.rate, &state.accepted, &state.rate_slope, &state.rate_partner})
    values->assign(static_cast<std::size_t>(dofs.rows()), 0);
  const std::vector<std::unique_ptr<Report>> none;
  FieldOutput(assembler, modules, none, ".", -1).write(7, state);
  const std::vector<double> corner = numbers("flow-000007.h5", "fields/corner");
  ASSERT_EQ(corner.size(), 4U);
  EXPECT_EQ(corner[0], 0);
  EXPECT_EQ(corner[1], 0);
  EXPECT_TRUE(std::isnan(corner[2]) && std::isnan(corner[3])) << "nobody tells it there";
  const Hdf5File file = Hdf5File::open(Communicator(), "flow-000007.h5");
  EXPECT_EQ(file.text("fields/corner", "of"), "cells");
  EXPECT_EQ(file.text("fields/corner", "unit"), "m");
}

/// Puts the cable in order from its tail and says where its nodes are in it.
class Order : public Report {
 public:
  explicit Order(const ReportSample& sample)
      : line_(*sample.dofs, sample.mesh.region("cable"), sample.mesh.region("tail")) {}
  const LineGeometry* line() const override { return &line_; }
  void add_fields(const Region& line, const State& /*state*/,
                  std::vector<PointField>& fields) const override {
    if (&line != &line_.region()) return;
    fields.push_back({"place", "", 1, {}});
    for (const LineGeometry::OwnedNode& node : line_.owned())
      fields.back().values.push_back(static_cast<double>(node.place));
  }

 private:
  LineGeometry line_;
};

TEST(FieldOutput, FollowsTheOrderOfAReportAndTakesItsFields) {
  const ReportSample sample;
  std::vector<std::unique_ptr<Report>> reports;
  reports.push_back(std::make_unique<Order>(sample));
  FieldOutput output(*sample.assembler, sample.modules, reports, ".", -1);
  output.write(4, sample.state);
  EXPECT_EQ(numbers("cable-000004.h5", "fields/arc_length"), (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(numbers("cable-000004.h5", "fields/place"), (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(numbers("cable-000004.h5", "points"),
            (std::vector<double>{4, 1, 0, 3, 1, 0, 2, 1, 0, 1, 1, 0, 0, 1, 0}));
}

}  // namespace
}  // namespace hawser
