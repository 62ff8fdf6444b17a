// Flows that a moving mesh must leave alone, and the mesh velocity that it takes.
#include <array>
#include <cmath>

#include "deck_run.hpp"
#include "figure.hpp"

namespace hawser {
namespace {

using Numbers = std::array<double, 2>;

/// A box of water in which every node is told where to go. The flow is prescribed on the boundary.
std::string box_deck(const std::string& flow, const std::string& displacement,
                     const std::string& scheme) {
  return R"(<hawser title="prescribed mesh">
  <mesh><water-box min="0 0" max="1 1" size="0.2"/></mesh>
  <modules>
    <ale-fluid region="water" density="1000" viscosity="10"/>
    <mesh-motion region="water"/>
  </modules>
  <conditions>
    <initial field="displacement" on="water" value=")" +
         displacement + R"("/>
    <initial field="velocity" on="water" value=")" +
         flow + R"("/>
    <prescribe field="displacement" on="water" value=")" +
         displacement + R"("/>
    <prescribe field="velocity" on="left right bottom top" value=")" +
         flow + R"("/>
    <prescribe field="pressure" on="corner" value="0"/>
  </conditions>
  <time step="0.1" end="10" )" +
         scheme + R"(/>
  <solver><linear method="mumps" tolerance="1e-13"/><newton tolerance="1e-13"/></solver>
</hawser>)";
}

/// Each node has its own velocity, also on the boundary.
const char* const each_its_own_way =
    "t*(0.05*sin(3*X)*cos(2*Y) + 0.02); t*(0.06*X*Y - 0.03*sin(5*X))";

const double pressure_scale = 1000;  // rho v^2, Pa

void expect_no_pressure(DeckRun& run) {
  const double pressure = run.deviation("pressure", "water", [](auto&&...) { return Numbers{}; });
  EXPECT_LE(pressure, 1e-11 * pressure_scale);
}

void record_error(const std::string& name, const std::string& what, const char* unit, double error,
                  double tolerance = 1e-12) {
  record({"moving_mesh." + name, "Invariants", what, unit, error, 0, tolerance, "round-off"});
}

struct Scheme {
  const char* name;
  const char* title;
  const char* attributes;
};
class MovingMesh : public testing::TestWithParam<Scheme> {};
INSTANTIATE_TEST_SUITE_P(Scheme, MovingMesh,
                         testing::Values(Scheme{"bdf2", "BDF2",
                                                R"(scheme="bdf2" start="initial-rates")"},
                                         Scheme{"newmark_0.5", "Newmark gamma = 0.5",
                                                R"(scheme="newmark" beta="0.25" gamma="0.5")"},
                                         Scheme{"newmark_0.6", "Newmark gamma = 0.6",
                                                R"(scheme="newmark" beta="0.3025" gamma="0.6")"},
                                         Scheme{"alpha_0.5", "generalised-alpha rho_infinity = 0.5",
                                                R"(scheme="generalised-alpha" rho-infinity="0.5")"},
                                         Scheme{"alpha_1", "generalised-alpha rho_infinity = 1",
                                                R"(scheme="generalised-alpha" rho-infinity="1")"}),
                         [](const auto& which) { return "N" + std::to_string(which.index); });

TEST_P(MovingMesh, PreservesUniformFlow) {
  DeckRun run(box_deck("0.8 -0.6", each_its_own_way, GetParam().attributes));
  for (int n = 0; n < 20; ++n)
    run.step();
  record_error(std::string("uniform_flow_") + GetParam().name,
               std::string("uniform flow after 20 steps of a moving mesh, ") + GetParam().title,
               "m/s", run.deviation("velocity", "water", [](auto&&...) {
                 return Numbers{0.8, -0.6};
               }));
  expect_no_pressure(run);
}

const double shear = 0.5;  // 1/s

Numbers shear_flow(const double* X, const double* d) { return {shear * (X[1] + d[1]), 0}; }

/// Starts with the rate that a shear flow has at a node that moves: dv/dt|_X = (k w_y, 0).
void start_consistently(DeckRun& run, double share_of_mesh_velocity = 1) {
  State initial = run.state();
  const int velocity = run.dofs().find("velocity");
  run.visit_nodes("displacement", "water", [&](LocalIndex row, const double*, const double*) {
    const RowInfo& info = run.dofs().info(row);
    const auto v = static_cast<std::size_t>(run.dofs().first_row(velocity, info.kind, info.point));
    const auto w = static_cast<std::size_t>(row);
    initial.rate[v] = shear * initial.rate[w + 1];
    initial.rate[v + 1] = 0;
    for (std::size_t c = 0; c < 2; ++c)
      initial.rate[w + c] *= share_of_mesh_velocity;
  });
  run.start_from(initial);
}

TEST_P(MovingMesh, PreservesLinearShear) {
  DeckRun run(box_deck("0.5*y; 0", each_its_own_way, GetParam().attributes));
  start_consistently(run);
  for (int n = 0; n < 20; ++n)
    run.step(n % 3 == 1 ? 0.05 : 0.1);
  const double error = run.deviation("velocity", "water", shear_flow);
  record_error(
      std::string("linear_shear_") + GetParam().name,
      std::string("linear shear after 20 uneven steps of a moving mesh, ") + GetParam().title,
      "m/s", error);
  expect_no_pressure(run);
}

// The test above would notice: with a mesh velocity that is wrong in the first step only ...
TEST_P(MovingMesh, WithAWrongFirstVelocityBreaksShear) {
  DeckRun run(box_deck("0.5*y; 0", each_its_own_way, GetParam().attributes));
  start_consistently(run, 0.99);
  run.step();
  EXPECT_GT(run.deviation("velocity", "water", shear_flow), 1e-7);
}

/// Largest part of the momentum contributions that does not cancel, inside of the boundary.
double imbalance(DeckRun& run) {
  std::vector<double> total, magnitude;
  run.system().assembler->residual(run.state(), total, magnitude);
  double worst = 0;
  run.visit_nodes("velocity", "water", [&](LocalIndex row, const double* X, const double*) {
    const bool inside = X[0] > 0.01 && X[0] < 0.99 && X[1] > 0.01 && X[1] < 0.99;
    if (!inside || row >= run.dofs().owned()) return;
    const auto r = static_cast<std::size_t>(row);
    worst = std::max(worst, std::abs(total[r]) / magnitude[r]);
  });
  return run.dofs().mesh().communicator.max(worst);
}

// ... or by a thousandth at any time.
TEST_P(MovingMesh, WithASlightlyWrongVelocityUnbalancesShear) {
  DeckRun run(box_deck("0.5*y; 0", each_its_own_way, GetParam().attributes));
  start_consistently(run);
  for (int n = 0; n < 5; ++n)
    run.step();
  EXPECT_LE(imbalance(run), 1e-12);
  run.visit_nodes("displacement", "water", [&](LocalIndex row, const double*, const double*) {
    for (LocalIndex c = 0; c < 2; ++c)
      run.state().rate[static_cast<std::size_t>(row + c)] *= 1.001;
  });
  EXPECT_GT(imbalance(run), 1e-6);
}

// Until t = 1 s the nodes move, then they stand still: w must forget that they moved.
TEST_P(MovingMesh, VelocityForgetsAKink) {
  DeckRun run(box_deck("0 0", "0.1*min(t, 1)*X*(1 - X); 0.2*min(t, 1)*Y", GetParam().attributes));
  const auto largest_velocity = [&] {
    return run.deviation_of(run.state().rate, "displacement", "water",
                            [](auto&&...) { return Numbers{}; });
  };
  const auto follow = [&](int steps) {
    for (int n = 0; n < steps; ++n) {
      run.system().problem->begin_step(0.1);
      run.system().problem->accept();
    }
  };
  follow(10);
  EXPECT_NEAR(largest_velocity(), 0.2, 1e-12);
  follow(1000);
  const double left = largest_velocity();
  record_error(std::string("kink_") + GetParam().name,
               std::string("mesh velocity left 1000 steps after a kink, ") + GetParam().title,
               "m/s", left);
}

// Linear displacement and velocity are solutions on any mesh.
TEST(PatchTest, OfFluidAndMesh) {
  DeckRun run(R"(<hawser title="patch test">
  <mesh><water-box min="0 0" max="1 1" size="0.2"/></mesh>
  <modules>
    <ale-fluid region="water" density="1000" viscosity="10"/>
    <mesh-motion region="water" stiffening-power="0"/>
  </modules>
  <conditions>
    <prescribe field="displacement" on="left right bottom top"
               value="0.1*X + 0.05*Y; 0.08*Y - 0.03*X"/>
    <prescribe field="velocity" on="left right bottom top" value="0.5*y; 0"/>
    <prescribe field="pressure" on="corner" value="0"/>
  </conditions>
  <time scheme="steady" end="1"/>
  <solver><linear method="mumps" tolerance="1e-13"/><newton tolerance="1e-13"/></solver>
</hawser>)");
  EXPECT_GE(run.step().iterations, 2);  // the geometry is not known beforehand
  const double displacement =
      run.deviation("displacement", "water", [](const double* X, auto&&...) {
        return Numbers{0.1 * X[0] + 0.05 * X[1], 0.08 * X[1] - 0.03 * X[0]};
      });
  const double velocity = run.deviation("velocity", "water", shear_flow);
  record_error("patch_test_displacement", "patch test: linear displacement", "m", displacement);
  record_error("patch_test_velocity", "patch test: linear velocity on the moved mesh", "m/s",
               velocity);
  expect_no_pressure(run);
}

}  // namespace
}  // namespace hawser
