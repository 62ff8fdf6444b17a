// Taylor-Hood: the DofMap takes a basis per field. A Stokes kernel of a few lines, velocity
// quadratic and pressure linear, against a manufactured solution.
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "figure.hpp"
#include "hawser/assembly/constraints.hpp"
#include "hawser/assembly/field_table.hpp"
#include "hawser/base/constants.hpp"
#include "hawser/element/tabulation.hpp"
#include "hawser/mesh/generate.hpp"
#include "hawser/physics/point_kernel.hpp"
#include "hawser/solve/linear_solver.hpp"

namespace hawser {
namespace {

constexpr double mu = 0.7;

struct Exact {
  double v[2], p;
};
Exact exact(double x, double y) {
  return {{std::sin(pi * x) * std::cos(pi * y), -std::cos(pi * x) * std::sin(pi * y)},
          std::sin(pi * x) * std::cos(pi * y)};
}
/// -div(mu (grad v + grad v^T) - p I)
std::array<double, 2> force(double x, double y) {
  const Exact at = exact(x, y);
  return {2 * pi * pi * mu * at.v[0] + pi * std::cos(pi * x) * std::cos(pi * y),
          2 * pi * pi * mu * at.v[1] - pi * std::sin(pi * x) * std::sin(pi * y)};
}

class StokesKernel : public PointKernel<StokesKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      FieldUse{"velocity", "m/s", "N/m", 2, RateRule::none, Role::adds, need::gradient}.wishing(
          Basis::p2),
      FieldUse{"pressure", "Pa", "m^2/s", 1, RateRule::none, Role::adds, need::value}};
  static constexpr Slot<0> velocity{};
  static constexpr Slot<1> pressure{};

  StokesKernel() : PointKernel("water") {}

  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    const auto& gradient = at[velocity].gradient;
    const auto load = force(at.position[0], at.position[1]);
    for (int i = 0; i < 2; ++i) {
      out[velocity].source[i] = -load[static_cast<std::size_t>(i)];
      for (int j = 0; j < 2; ++j)
        out[velocity].flux(i, j) = mu * (gradient(i, j) + gradient(j, i));
      out[velocity].flux(i, i) -= at[pressure].value;
    }
    out[pressure].source = trace(gradient);
  }
};

/// Velocity on the whole boundary, pressure at one corner.
std::vector<PrescribedRow> boundary_values(const DofMap& dofs) {
  std::vector<PrescribedRow> rows;
  const auto prescribe = [&](int field, const char* region, auto&& value_of) {
    for (const LocalIndex first : dofs.region_rows(field, dofs.mesh().region(region))) {
      if (first >= dofs.owned()) continue;
      double x[2];
      dofs.position(first, x);
      for (int c = 0; c < dofs.fields()[static_cast<std::size_t>(field)].components; ++c)
        rows.push_back({first + c, value_of(exact(x[0], x[1]), c)});
    }
  };
  for (const char* side : {"left", "right", "bottom", "top"})
    prescribe(dofs.find("velocity"), side, [](const Exact& at, int c) { return at.v[c]; });
  prescribe(dofs.find("pressure"), "corner", [](const Exact& at, int) { return at.p; });
  return rows;
}

void solve(Assembler& assembler, State& state) {
  Constraints constraints(assembler);
  constraints.prescribe(boundary_values(assembler.dofs()));
  std::vector<double> residual, magnitude;
  assembler.residual(state, residual, magnitude);
  constraints.apply(state, {}, residual, magnitude);
  assembler.tangent(state);
  constraints.apply(Kinematics{});

  const BlockSystem& system = assembler.system();
  TpetraVector rhs(system.rows), x(system.rows);
  const auto view = rhs.getDataNonConst();
  for (std::size_t row = 0; row < residual.size(); ++row)
    view[static_cast<Teuchos::Ordinal>(row)] = -residual[row];
  LinearOptions options;
  options.method = LinearOptions::Method::mumps;
  options.tolerance = 1e-12;
  LinearSolver(assembler.system(), options).solve(rhs, x);
  assembler.spread(x, state.value);
}

/// L2 norms of the errors in velocity and pressure.
std::array<double, 2> errors(const DofMap& dofs, const State& state) {
  const Mesh& mesh = dofs.mesh();
  const Region& water = mesh.region("water");
  const Quadrature rule = quadrature(CellShape::triangle, 8);
  const Tabulation shapes[2] = {tabulate(Basis::p2, rule), tabulate(Basis::p1, rule)};
  const int field[2] = {dofs.find("velocity"), dofs.find("pressure")};
  double sum[2] = {0, 0};
  for (LocalIndex cell = 0; cell < water.size(); ++cell) {
    if (water.cell_owners[static_cast<std::size_t>(cell)] != mesh.communicator.rank()) continue;
    const double* X[3];
    for (int v = 0; v < 3; ++v)
      X[v] = &mesh.coordinates[2 * static_cast<std::size_t>(
                                       water.vertices[static_cast<std::size_t>(3 * cell + v)])];
    const double twice_area =
        (X[1][0] - X[0][0]) * (X[2][1] - X[0][1]) - (X[2][0] - X[0][0]) * (X[1][1] - X[0][1]);
    for (int f = 0; f < 2; ++f) {
      const Tabulation& shape = shapes[f];
      std::vector<LocalIndex> rows;
      dofs.append_cell_rows(field[f], water, cell, rows);
      for (int q = 0; q < rule.points; ++q) {
        const double* const xi = &rule.locations[static_cast<std::size_t>(2 * q)];
        double x[2];
        for (int j = 0; j < 2; ++j)
          x[j] = X[0][j] + xi[0] * (X[1][j] - X[0][j]) + xi[1] * (X[2][j] - X[0][j]);
        const Exact wanted = exact(x[0], x[1]);
        for (int c = 0; c < (f == 0 ? 2 : 1); ++c) {
          double error = f == 0 ? -wanted.v[c] : -wanted.p;
          for (int a = 0; a < shape.nodes; ++a)
            error += shape.values[static_cast<std::size_t>(q * shape.nodes + a)] *
                     state.value[static_cast<std::size_t>(rows[static_cast<std::size_t>(a)] + c)];
          sum[f] += rule.weights[static_cast<std::size_t>(q)] * twice_area * error * error;
        }
      }
    }
  }
  return {std::sqrt(mesh.communicator.sum(sum[0])), std::sqrt(mesh.communicator.sum(sum[1]))};
}

std::array<double, 2> errors_with(int cells) {
  const Communicator all;
  WaterBox square;
  square.min = {0, 0}, square.max = {1, 1};
  square.cells.assign(2, cells);
  generate_mesh(all, square, "square.msh");
  const Mesh mesh = read_mesh(all, {"square.msh", {}});
  std::vector<PhysicsModule> modules(1);
  modules[0].name = modules[0].block = "stokes";
  modules[0].kernels.push_back(std::make_unique<StokesKernel>());
  const DofMap dofs(mesh, gather_fields(modules).fields);
  const GlobalIndex n = cells;
  EXPECT_EQ(dofs.global_count(), 2 * (2 * n + 1) * (2 * n + 1) + (n + 1) * (n + 1));
  Assembler assembler(dofs, modules);
  State state;
  for (auto* array :
       {&state.value, &state.rate, &state.accepted, &state.rate_slope, &state.rate_partner})
    array->assign(static_cast<std::size_t>(dofs.rows()), 0);
  solve(assembler, state);
  return errors(dofs, state);
}

TEST(TaylorHood, ConvergesWithOrderThreeInVelocityAndTwoInPressure) {
  std::array<double, 2> order{}, coarse = errors_with(4);
  for (const int cells : {8, 16, 32}) {
    const auto fine = errors_with(cells);
    for (std::size_t f = 0; f < 2; ++f)
      order[f] = std::log2(coarse[f] / fine[f]);
    if (Communicator().is_root())
      std::printf("  %2d cells: velocity %.3e (order %.2f), pressure %.3e (order %.2f)\n", cells,
                  fine[0], order[0], fine[1], order[1]);
    coarse = fine;
  }
  record({"stokes.velocity_order", "Orders of accuracy", "Taylor-Hood (P2/P1) Stokes: velocity, L2",
          "1", order[0], 3, 0.1, "theory; 16 to 32 cells a side", "at-least"});
  record({"stokes.pressure_order", "Orders of accuracy", "Taylor-Hood (P2/P1) Stokes: pressure, L2",
          "1", order[1], 2, 0.1, "theory; 16 to 32 cells a side", "at-least"});
}

}  // namespace
}  // namespace hawser
