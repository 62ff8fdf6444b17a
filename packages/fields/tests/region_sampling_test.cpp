#include "hawser/fields/region_sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "hawser/base/exact_sum.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

/// 4 by 2 unit squares, moved by d = (0.1 X + 0.2 Y, 0.5 Y): a parallelogram.
class Region2D : public testing::TestWithParam<Basis> {
 protected:
  static Mesh make_mesh() {
    MeshText text = grid(4, 2);
    text.groups.push_back(line("floor", {0, 1, 2, 3, 4}));
    text.groups.push_back(line("cable", {6, 7, 8}));
    text.groups.push_back({"half", 2, {{0, 1, 6}, {0, 6, 5}}});
    return read_text(Communicator(), text.in_format("4.1"), {"cable"});
  }
  Region2D()
      : mesh_(make_mesh()),
        dofs_(mesh_, {{"temperature", "K", "W/m", 1, GetParam(), Numbering::continuous, {"water"}},
                      {"velocity", "m/s", "N/m", 2, GetParam(), Numbering::continuous, {"water"}},
                      {"pressure", "Pa", "m^2/s", 1, Basis::p1, Numbering::sides, {"water"}},
                      {"displacement", "m", "m", 2, GetParam(), Numbering::continuous, {"water"}},
                      {"tint", "1", "1", 1, Basis::p1, Numbering::continuous, {"half"}}}) {
    state_.time = 2;
    state_.value.assign(static_cast<std::size_t>(dofs_.rows()), 0);
    for (LocalIndex row = 0; row < dofs_.rows(); ++row) {
      const RowInfo& info = dofs_.info(row);
      double X[2];
      dofs_.position(row, X);
      const double x = 1.1 * X[0] + 0.2 * X[1], y = 1.5 * X[1];
      const double values[][2] = {
          {3 + x - 2 * y, 0}, {y, -x}, {7, 0}, {x - X[0], y - X[1]}, {1, 0}};
      state_.value[static_cast<std::size_t>(row)] = values[info.field][info.component];
    }
  }

  std::string faults(const std::string& formula, const char* region) {
    Diagnostics diagnostics;
    RegionSampling(dofs_, mesh_.region(region), FieldExpression(formula, {"d.xml", 1, 2}), 3,
                   quadrature, diagnostics);
    return diagnostics.error_text();
  }
  double integral(const std::string& formula, const char* region) {
    Diagnostics diagnostics;
    RegionSampling sampling(dofs_, mesh_.region(region), FieldExpression(formula), 3, quadrature,
                            diagnostics);
    EXPECT_EQ(diagnostics.error_text(), "");
    std::vector<double> terms;
    sampling.visit(state_, [&](const auto& at) { terms.push_back(at.weight * at.value); });
    return exact_sum(mesh_.communicator, terms);
  }

  Mesh mesh_;
  DofMap dofs_;
  State state_;
};

INSTANTIATE_TEST_SUITE_P(Bases, Region2D, testing::Values(Basis::p1, Basis::p2));

TEST_P(Region2D, IsTheMovedOne) {
  EXPECT_NEAR(integral("1", "water"), 8 * 1.1 * 1.5, 1e-12);
  EXPECT_NEAR(integral("1", "floor"), 4.4, 1e-13);
  EXPECT_NEAR(integral("1", "wall"), 2 * 4.4 + 2 * std::hypot(0.4, 3), 1e-13);
  EXPECT_NEAR(integral("1", "cable"), 2.2, 1e-13);
}

TEST_P(Region2D, FormulasAreIntegratedExactly) {
  // Mean place of the parallelogram: (2.4, 1.5).
  const double area = 8 * 1.1 * 1.5;
  EXPECT_NEAR(integral("temperature", "water"), area * (3 + 2.4 - 3), 1e-12);
  EXPECT_NEAR(integral("t*x", "water"), area * 4.8, 1e-12);
  EXPECT_NEAR(integral("X*Y", "water"), 8 * 1.1 * 1.5 * 2, 1e-12);
  EXPECT_NEAR(integral("dx(temperature) + 10*dy(temperature) + 100*dy(velocity_x)", "water"),
              area * (1 - 20 + 100), 1e-11);
  // 3 + x - 2 y over y = 0, x in [0, 4.4], times the same: integral of (3 + x)^2.
  EXPECT_NEAR(integral("temperature*temperature", "floor"), (std::pow(7.4, 3) - 27) / 3, 1e-12);
}

TEST_P(Region2D, TheBoundarySeesTheCellsBesideIt) {
  EXPECT_NEAR(integral("normal_y", "floor"), -4.4, 1e-13);
  EXPECT_NEAR(integral("normal_x", "wall"), 0, 1e-13);
  // Gauss: of grad T . n all round, and of v . n, both without a source; of place, twice the area.
  EXPECT_NEAR(integral("dx(temperature)*normal_x + dy(temperature)*normal_y", "wall"), 0, 1e-12);
  EXPECT_NEAR(integral("dy(temperature)*normal_y", "floor"), 8.8, 1e-12);
  EXPECT_NEAR(integral("x*normal_x + y*normal_y", "wall"), 2 * 13.2, 1e-12);
  EXPECT_NEAR(integral("pressure*normal_y", "floor"), -7 * 4.4, 1e-12);
}

TEST_P(Region2D, WhatDoesNotFitIsSaid) {
  EXPECT_EQ(faults("2*temprature", "water"),
            "d.xml:1:2: 'temprature' in the formula '2*temprature' is no field of this run and no "
            "parameter; there "
            "are temperature, velocity_x, velocity_y, pressure, displacement_x, displacement_y, "
            "tint; did you mean 'temperature'?");
  EXPECT_EQ(faults("velocity", "water"),
            "d.xml:1:2: 'velocity' in the formula 'velocity' is a field of 2 components; write "
            "velocity_x or velocity_y");
  EXPECT_EQ(faults("dx(temperature_x)", "water"),
            "d.xml:1:2: 'dx(temperature_x)' in the formula 'dx(temperature_x)' is a component, and "
            "'temperature' has only one; write temperature");
  EXPECT_NE(faults("velocity_z", "water").find("the third component of a field of two"),
            std::string::npos);
  EXPECT_NE(faults("dz(temperature)", "water").find("a derivative along z"), std::string::npos);
  EXPECT_NE(faults("normal_x", "water").find("known on the boundary of a body only"),
            std::string::npos);
  EXPECT_EQ(faults("dx(temperature)", "cable"),
            "d.xml:1:2: the formula 'dx(temperature)' on region 'cable': a derivative has two "
            "values on a line within the body, and one on its boundary");
  EXPECT_NE(faults("pressure", "cable").find("two values"), std::string::npos);
  EXPECT_NE(faults("tint", "water").find("'tint' is not solved for all over it"),
            std::string::npos);
  EXPECT_EQ(faults("tint", "half"), "");
}

TEST(Lattice, HasTheVerticesAndWhatIsBetween) {
  EXPECT_EQ(lattice(CellShape::triangle, 1).points, 3);
  EXPECT_EQ(lattice(CellShape::triangle, 4).points, 15);
  EXPECT_EQ(lattice(CellShape::quadrilateral, 2).points, 9);
  EXPECT_EQ(lattice(CellShape::line, 2).locations, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(lattice(CellShape::tetrahedron, 1).points, 4);
}

}  // namespace
}  // namespace hawser
