// One step of a cable in a flow: balance of the interface, and the order of Newton's method.
#include <algorithm>
#include <cmath>

#include "deck_run.hpp"
#include "figure.hpp"

namespace hawser {
namespace {

/// A 420 m cable along the current, held for 100 s; then its top moves, and its tail if it is told
/// to.
std::string tow_deck(const std::string& top, const std::string& tail = "") {
  return R"(<hawser title="coupled step">
  <mesh slits="cable">
    <tow-box min="-1500 -2000" max="1500 1500" tail="0 -420" cable-size="20"/>
  </mesh>
  <modules>
    <ale-fluid region="water" density="1000" viscosity="300">
      <outflow on="outflow" kind="pressure" pressure="0" backflow="0.5"/>
    </ale-fluid>
    <cable region="cable" mass-per-length="60" axial-stiffness="1e6" bending-stiffness="1e7"/>
    <mesh-motion region="water"/>
  </modules>
  <conditions>
    <initial field="velocity" on="water" value="0 -0.5"/>
    <initial field="velocity" on="cable" value="0 0"/>
    <prescribe field="velocity" on="inflow" value="0 -0.5"/>
    <prescribe field="velocity" on="sides" component="x" value="0"/>
    <prescribe field="displacement" on="inflow outflow sides" value="0 0"/>
    <prescribe field="displacement" on="cable" until="100" value="0 0"/>
    <prescribe field="displacement" on="tow-point" from="100" value=")" +
         top + R"("/>)" +
         (tail.empty() ? ""
                       : R"(<prescribe field="displacement" on="tail" from="100" value=")" + tail +
                             R"("/>)") +
         R"(
  </conditions>
  <time beta="0.3025" gamma="0.6" step="20" end="1000"/>
  <solver>
    <linear method="mumps" tolerance="1e-13"/>
    <newton tolerance="1e-12" lagged="false"/>
  </solver>
</hawser>)";
}

const char* const along_and_across = "0.2*(t - 100); 0.1*(t - 100)";
const char* const the_same_stretched = "0.2*(t - 100); 0.1*(t - 100) - 20*ramp(t, 100, 100)";
const char* const toward_the_tail = "0; -0.3*(t - 100)";

/// Held for 100 s, then `steps` steps under way.
NonlinearReport last_step_under_way(DeckRun& run, int steps) {
  for (int n = 0; n < 5; ++n)
    run.step();
  for (int n = 1; n < steps; ++n)
    run.step();
  return run.step();
}

int module_index(System& system, const std::string& name) {
  for (std::size_t m = 0; m < system.modules.size(); ++m)
    if (system.modules[m].name == name) return static_cast<int>(m);
  ADD_FAILURE() << "no module " << name;
  return 0;
}

TEST(Interface, FluidAndCableForcesCancelAtTheFreeNodesOfTheCable) {
  DeckRun run(tow_deck(along_and_across));
  last_step_under_way(run, 5);
  System& system = run.system();
  std::vector<double> fluid, cable, total, scale;
  system.assembler->residual(run.state(), fluid, module_index(system, "ale-fluid"));
  system.assembler->residual(run.state(), cable, module_index(system, "cable"));
  system.assembler->residual(run.state(), total, scale);

  double tow_force = 0, transferred = 0, not_total = 0, unbalanced = 0;
  const LocalIndex owned = run.dofs().owned();
  const int velocity = run.dofs().find("velocity");
  const auto tow_rows = run.dofs().region_rows(velocity, run.dofs().mesh().region("tow-point"));
  run.visit_nodes("velocity", "cable", [&](LocalIndex first, const double*, const double*) {
    if (first >= owned) return;
    const bool towed = std::find(tow_rows.begin(), tow_rows.end(), first) != tow_rows.end();
    for (const LocalIndex row : {first, first + 1}) {
      const auto r = static_cast<std::size_t>(row);
      not_total = std::max(not_total, std::abs(fluid[r] + cable[r] - total[r]) / scale[r]);
      if (towed)
        tow_force = std::max(tow_force, std::abs(total[r]));
      else {
        unbalanced = std::max(unbalanced, std::abs(total[r]) / scale[r]);
        transferred = std::max(transferred, std::abs(fluid[r]));
      }
    }
  });
  const Communicator& all = run.dofs().mesh().communicator;
  EXPECT_LE(all.max(not_total), 1e-13);
  record({"coupled_step.interface_balance", "Invariants",
          "forces of fluid and cable at the cable's free nodes: part that does not cancel", "1",
          all.max(unbalanced), 0, 1e-10, "round-off and Newton's tolerance"});
  EXPECT_GT(all.max(transferred), 1e3);  // N/m: something was there to cancel
  EXPECT_GT(all.max(tow_force), 1e3);
}

/// From the last three residuals above the round-off floor: log(r3/r2) / log(r2/r1). Residuals are
/// relative; where the driver sees nothing but round-off they are 0.
double newton_order(const std::vector<double>& residuals) {
  constexpr double floor = 1e-13;
  std::vector<double> above;
  std::copy_if(residuals.begin(), residuals.end(), std::back_inserter(above),
               [](double r) { return r > floor; });
  if (above.size() < 3) return 0;
  const double* const last = &above[above.size() - 3];
  return std::log(last[2] / last[1]) / std::log(last[1] / last[0]);
}

void print_ratios(const NonlinearReport& report) {
  if (!Communicator().is_root()) return;
  std::printf("  residuals of the worst block:");
  for (const double ratio : report.ratios)
    std::printf(" %.1e", ratio);
  std::printf("\n");
}

/// Least tension of the cable, N.
double least_tension(DeckRun& run) {
  const Mesh& mesh = run.dofs().mesh();
  double least = 1e30;
  for (const auto& quantity :
       run.system().assembler->cell_quantities(mesh.region("cable"), run.state()))
    for (const double tension : quantity.values)
      least = std::min(least, tension);
  return mesh.communicator.min(least);
}

TEST(Newton, IsQuadraticInATautCoupledStep) {
  DeckRun run(tow_deck(along_and_across, the_same_stretched));
  const NonlinearReport report = last_step_under_way(run, 4);
  print_ratios(report);
  EXPECT_GT(least_tension(run), 1e3);
  EXPECT_TRUE(report.converged);
  const double order = newton_order(report.ratios);
  record({"coupled_step.newton_order", "Invariants",
          "Newton's order in a taut coupled step, last three residuals above round-off", "1", order,
          2, 0.2, "theory", "at-least"});
}

TEST(Newton, ConvergesInASlackStep) {
  DeckRun run(tow_deck(toward_the_tail));
  const NonlinearReport report = last_step_under_way(run, 5);
  print_ratios(report);
  EXPECT_LE(least_tension(run), 0);
  EXPECT_TRUE(report.converged);
}

}  // namespace
}  // namespace hawser
