#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hawser/solve/linear_solver.hpp"
#include "reaction_transport.hpp"
#include "spring_chain.hpp"
#include "src/patch.hpp"

namespace hawser {
namespace {

using test::ReactionTransport;
using test::SpringChain;
using BlockMethod = LinearOptions::BlockMethod;
using testing::ElementsAre;
using testing::HasSubstr;

LinearOptions blocks(BlockMethod method) {
  LinearOptions options;
  options.method = LinearOptions::Method::blocks;
  options.block_method = method;
  return options;
}

/// Heat and chemistry as two groups, each of one unknown per node.
struct TwoGroups {
  explicit TwoGroups(int side) : problem(side), rhs(problem.system().rows), x(rhs.getMap()) {
    problem.jacobian(problem.exact());
    RowLayout& layout = problem.system().layout;
    layout.groups = {{"heat"}, {"chemistry"}};
    layout.dimension = 2;
    layout.kinds = 2;
    for (LocalIndex row = 0; row < static_cast<LocalIndex>(rhs.getLocalLength()); ++row) {
      layout.group.push_back(row % 2);
      layout.node.push_back(row / 2);
      layout.kind.push_back(row % 2);
      const auto node = rhs.getMap()->getGlobalElement(row) / 2;
      if (row % 2 == 0)
        layout.positions.insert(layout.positions.end(), {static_cast<double>(node % side),
                                                         static_cast<double>(node / side)});
      rhs.replaceLocalValue(row, row % 2 == 0 ? 1e3 : 1e-3);
    }
    layout.prescribed.assign(rhs.getLocalLength(), 0);
  }

  /// Of x to the solution by a complete factor, relative.
  double error() {
    LinearOptions options;
    options.method = LinearOptions::Method::mumps;
    LinearSolver mumps(problem.system(), options);
    TpetraVector exact(x.getMap());
    mumps.solve(rhs, exact, 1e-12);
    const double size = exact.norm2();
    exact.update(1.0, x, -1.0);
    return exact.norm2() / size;
  }

  ReactionTransport problem;
  TpetraVector rhs, x;
};

struct Offered {
  BlockMethod method;
  int side, most_iterations;
  const char* told;
};

class BlockFactorTest : public testing::TestWithParam<Offered> {};

TEST_P(BlockFactorTest, AgreesWithTheCompleteFactor) {
  TwoGroups sample(GetParam().side);
  LinearSolver solver(sample.problem.system(), blocks(GetParam().method));
  const LinearReport report = solver.solve(sample.rhs, sample.x, 1e-11);
  EXPECT_LE(report.iterations, GetParam().most_iterations);
  EXPECT_LT(sample.error(), 1e-8);
  EXPECT_THAT(solver.take_notes(), ElementsAre(HasSubstr(GetParam().told)));
}

// Two groups that depend on each other both ways take the iterations of their coupling; multigrid
// adds its own.
INSTANTIATE_TEST_SUITE_P(
    All, BlockFactorTest,
    testing::Values(
        Offered{BlockMethod::direct, 24, 12, "heat: MUMPS; chemistry: MUMPS"},
        Offered{BlockMethod::automatic, 24, 12, "heat: MUMPS; chemistry: MUMPS"},
        Offered{BlockMethod::multigrid, 24, 12, "heat: MUMPS, not multigrid, because it is small"},
        Offered{BlockMethod::multigrid, 80, 24, "heat: multigrid; chemistry: multigrid"}));

TEST(BlockFactor, WithoutALayoutIsOneCompleteFactor) {
  ReactionTransport problem(24);
  problem.jacobian(problem.exact());
  TpetraVector rhs(problem.system().rows), x(rhs.getMap());
  rhs.putScalar(1);
  LinearSolver solver(problem.system(), blocks(BlockMethod::automatic));
  EXPECT_EQ(solver.solve(rhs, x, 1e-10).iterations, 1);
  EXPECT_THAT(solver.take_notes(), ElementsAre("linear solver: everything: MUMPS"));
}

TEST(BlockFactor, FollowersAreTakenOutExactly) {
  SpringChain chain(40);
  TpetraVector rhs(chain.system.rows), x(rhs.getMap());
  rhs.randomize();
  LinearSolver solver(chain.system, blocks(BlockMethod::direct));
  EXPECT_EQ(solver.solve(rhs, x, 1e-10).iterations, 1);
  chain.hold_end();  // its displacement and velocity are given
  solver.matrix_changed();
  EXPECT_EQ(solver.solve(rhs, x, 1e-10).iterations, 1);
  chain.system.layout.ordered = false;  // as in a steady solve
  solver.drop_factor();
  EXPECT_EQ(solver.solve(rhs, x, 1e-10).iterations, 1);
}

TEST(BlockFactor, FallsBackToSaferFactorsAndSaysSo) {
  TwoGroups sample(80);
  LinearOptions options = blocks(BlockMethod::multigrid);
  options.max_iterations = 2;
  LinearSolver solver(sample.problem.system(), options);
  EXPECT_EQ(solver.solve(sample.rhs, sample.x, 1e-10).iterations, 2 + 2 + 1);
  EXPECT_THAT(solver.take_notes(), ElementsAre(HasSubstr("multigrid; "), HasSubstr("heat: MUMPS; "),
                                               HasSubstr("everything: MUMPS")));
  solver.matrix_changed();  // it stays so ...
  EXPECT_EQ(solver.solve(sample.rhs, sample.x, 1e-10).iterations, 1);
  solver.forget();  // ... until the run may be restarted from here
  EXPECT_EQ(solver.solve(sample.rhs, sample.x, 1e-10).iterations, 2 + 2 + 1);
}

// An old factor knows nothing of rows that were free or held.
TEST(LinearSolver, DropsAKeptFactorWhenOtherRowsArePrescribed) {
  using Method = LinearOptions::Method;
  for (const Method method : {Method::gmres, Method::mumps, Method::blocks}) {
    SpringChain chain(40);
    TpetraVector rhs(chain.system.rows), x(rhs.getMap());
    rhs.putScalar(1);
    LinearOptions options;
    options.method = method;
    options.keep_factor = true;
    LinearSolver solver(chain.system, options);
    EXPECT_TRUE(solver.solve(rhs, x).factored);
    solver.matrix_changed();
    EXPECT_FALSE(solver.solve(rhs, x).factored);
    chain.hold_end();
    solver.matrix_changed();
    EXPECT_TRUE(solver.solve(rhs, x).factored);
  }
}

TEST(Patch, TakesTheResidualAwayNearItsSeeds) {
  ReactionTransport problem(24);
  problem.jacobian(problem.exact());
  const auto matrix = problem.system().matrix;
  std::vector<char> seeds(matrix->getNodeNumRows(), 0);
  if (Communicator().is_root()) seeds[10] = 1;
  Patch patch(Communicator(), matrix, seeds, true);
  ASSERT_TRUE(patch.exists());
  patch.numeric();
  TpetraVector b(matrix->getRowMap()), y(b.getMap()), rest(b.getMap());
  b.putScalar(1);
  y.randomize();
  patch.correct(b, y);
  matrix->apply(y, rest);
  rest.update(1.0, b, -1.0);
  const auto view = rest.getLocalViewHost(Tpetra::Access::ReadOnly);
  long long gone = 0;
  for (std::size_t row = 0; row < rest.getLocalLength(); ++row)
    if (std::abs(view(row, 0)) < 1e-8) ++gone;
  EXPECT_EQ(Communicator().sum(gone), patch.rows());
  EXPECT_GE(patch.rows(), 16) << "three layers of a five-point star at an edge, two fields";
}

TEST(Patch, OfNearlyEverythingThereIsNone) {
  ReactionTransport problem(24);
  problem.jacobian(problem.exact());
  const auto matrix = problem.system().matrix;
  EXPECT_FALSE(
      Patch(Communicator(), matrix, std::vector<char>(matrix->getNodeNumRows(), 1), true).exists());
  EXPECT_FALSE(
      Patch(Communicator(), matrix, std::vector<char>(matrix->getNodeNumRows(), 0), true).exists());
}

}  // namespace
}  // namespace hawser
