// Every linear solver that a deck can choose gives the solution that MUMPS' complete factor gives,
// for the Jacobian of every shipped physics, on any number of ranks: a solver that is silently
// wrong is found here.
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>

#include "hawser/simulation/stepper.hpp"
#include "src/system.hpp"

namespace hawser {
namespace {

struct Physics {
  const char* name;
  const char* deck;
  int steps;  ///< before the Jacobian is looked at
  std::vector<DeckChange> changes{};
  bool incomplete = true;  ///< an incomplete factor of the whole is offered for it, too
};

std::ostream& operator<<(std::ostream& stream, const Physics& physics) {
  return stream << physics.name;
}

struct Solver {
  std::string name;
  LinearOptions options;
};

std::vector<Solver> offered(const Physics& physics) {
  using Method = LinearOptions::Method;
  using BlockMethod = LinearOptions::BlockMethod;
  std::vector<Solver> result;
  const auto add = [&](const std::string& name, Method method) {
    result.push_back({name, {}});
    result.back().options.method = method;
    return &result.back().options;
  };
  if (physics.incomplete) add("gmres", Method::gmres);
  add("mumps on all ranks", Method::mumps)->repeatable = false;
  add("blocks", Method::blocks);
  add("direct blocks", Method::blocks)->block_method = BlockMethod::direct;
  add("direct blocks on all ranks", Method::blocks)->repeatable = false;
  add("multigrid blocks", Method::blocks)->block_method = BlockMethod::multigrid;
  return result;
}

/// Of the difference of two solutions relative to the second, per field the largest.
double difference(const BlockSystem& system, const TpetraVector& a, const TpetraVector& b) {
  std::map<std::string, std::array<double, 2>> sums;
  const auto of_a = a.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto of_b = b.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (const Block& block : system.blocks) {
    auto& sum = sums[block.field];
    for (const LocalIndex row : block.rows) {
      sum[0] += std::pow(of_a(row, 0) - of_b(row, 0), 2);
      sum[1] += std::pow(of_b(row, 0), 2);
    }
  }
  double worst = 0;
  for (const auto& [field, sum] : sums)
    worst = std::max(worst,
                     std::sqrt(system.communicator.sum(sum[0]) / system.communicator.sum(sum[1])));
  return worst;
}

class LinearSolvers : public testing::TestWithParam<Physics> {};

TEST_P(LinearSolvers, AgreeWithMumps) {
  const Physics& physics = GetParam();
  const Environment environment;
  CaseOptions options;
  options.expects = false;
  options.changes = physics.changes;
  options.changes.push_back({"solver/linear/method", "mumps"});
  const std::string root = HAWSER_TEST_ROOT;
  Stepper stepper(Case::from_file(environment, root + "/" + physics.deck, options));
  for (int step = 0; step < physics.steps; ++step)
    ASSERT_TRUE(stepper.advance().accepted);
  CoupledProblem& problem = *stepper.system().problem;
  BlockSystem& system = problem.system();
  TpetraVector b(system.rows), exact(system.rows), x(system.rows);
  problem.jacobian(*problem.guess());
  x.randomize();
  system.matrix->apply(x, b);

  LinearOptions complete;
  complete.method = LinearOptions::Method::mumps;
  LinearSolver(system, complete).solve(b, exact, 1e-12);
  for (const Solver& solver : offered(physics)) {
    LinearSolver linear(system, solver.options);
    const LinearReport report = linear.solve(b, x, 1e-11);
    std::string notes;
    for (const std::string& note : linear.take_notes())
      notes += "; " + note;
    const double off = difference(system, x, exact);
    EXPECT_LT(off, 1e-5) << solver.name << notes;
    const bool of_everything = solver.options.method == LinearOptions::Method::gmres;
    EXPECT_LE(report.iterations, of_everything ? 200 : 60) << solver.name << notes;
    if (system.communicator.is_root())
      std::printf("%-28s %3d iterations, off by %.1e%s\n", solver.name.c_str(), report.iterations,
                  off, notes.c_str());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shipped, LinearSolvers,
    testing::Values(Physics{"held_tow", "inputs/deep_tow/case_02_quick.xml", 1},
                    Physics{"tow_under_way", "inputs/tutorials/short_tow.xml", 18},
                    Physics{"flow_with_sides", "inputs/tutorials/two_waters.xml", 1},
                    Physics{"steady_flow", "inputs/verification/cavity.xml", 1},
                    Physics{
                        "cable_in_a_given_current", "inputs/deep_tow/drag_law.xml", 2, {}, false},
                    Physics{"cable_at_rest", "inputs/structures/hung_cable.xml", 1, {}, false},
                    Physics{"beam", "inputs/structures/cantilever.xml", 1, {}, false},
                    Physics{"cable_in_space", "inputs/deep_tow/drag_law_space.xml", 2, {}, false},
                    Physics{"coupled", "inputs/verification/coupled_space.xml", 1}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace hawser
