// All equations of a step at once: loads of modules, values of conditions, the instants of the
// scheme.
#include "hawser/time/coupled_problem.hpp"

#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include "hawser/deck/deck.hpp"
#include "sample_integrator.hpp"

namespace hawser {
namespace {

constexpr double load = 2;  // at each node of each cell

ConditionsDeck conditions_of(const std::string& text) {
  Diagnostics diagnostics;
  const Deck deck = parse_deck("<conditions>" + text + "</conditions>", "test", diagnostics);
  const ConditionsDeck result = ConditionsDeck::spec().read(deck.root, diagnostics);
  diagnostics.throw_if_any();
  return result;
}

/// Water that is loaded at every node, with a velocity that is prescribed on a line through it.
struct Sample {
  Mesh mesh = sample_mesh();
  std::vector<PhysicsModule> modules = loaded_water();
  FieldTable table = gather_fields(modules);
  DofMap dofs{mesh, table.fields};
  Assembler assembler{dofs, modules};
  Diagnostics diagnostics;
  Conditions conditions{assembler,
                        table.rate_rules,
                        conditions_of(R"(<initial field="velocity" on="water" value="1 1"/>
            <prescribe field="velocity" on="cable" value="3 + 2*t; 0"/>)"),
                        {},
                        diagnostics};
  TimeIntegrator integrator;
  CoupledProblem problem{assembler, integrator, conditions};

  explicit Sample(const TimeScheme& scheme) : integrator(assembler, table.rate_rules, scheme) {
    diagnostics.throw_if_any();
    conditions.set_initial(problem.state());
    problem.start();
  }

  static std::vector<PhysicsModule> loaded_water() {
    std::vector<PhysicsModule> result;
    result.push_back(module_with(
        "flow", std::make_unique<LoadKernel>("water", CellShape::triangle,
                                             std::vector<FieldUse>{velocity(Role::adds)}, load)));
    return result;
  }
  std::vector<LocalIndex> held() const { return dofs.region_rows(0, mesh.region("cable")); }
};

TEST(CoupledProblem, HoldsPrescribedValuesAtTheInstantAndAtTheEnd) {
  TimeScheme scheme;
  scheme.method = TimeScheme::Method::generalised_alpha;
  scheme.euler_start = false;
  Sample sample(scheme);
  const double alpha_f = scheme.coefficients(0.5, 0).alpha_f;
  sample.problem.begin_step(0.5);
  sample.problem.finish_step(*sample.problem.guess());
  for (const LocalIndex row : sample.held()) {
    const auto r = static_cast<std::size_t>(row);
    EXPECT_NEAR(sample.problem.end().value[r], 4, 1e-14);                        // 3 + 2*0.5
    EXPECT_NEAR(sample.problem.state().value[r], 3 + 2 * 0.5 * alpha_f, 1e-14);  // at the instant
    EXPECT_EQ(sample.integrator.history().value[r], 1);
  }
  sample.problem.accept();
  EXPECT_EQ(sample.integrator.history().time, 0.5);
  for (const LocalIndex row : sample.held())
    EXPECT_NEAR(sample.integrator.history().value[static_cast<std::size_t>(row)], 4, 1e-14);
}

TEST(CoupledProblem, ReactionsAreTheBalanceBeforeAnyCondition) {
  Sample sample({});
  sample.problem.begin_step(0.5);
  const auto x = sample.problem.guess();
  sample.problem.finish_step(*x);
  double along_x = 0;
  for (LocalIndex row = 0; row < sample.dofs.owned(); ++row)
    if (sample.dofs.info(row).component == 0)
      along_x += sample.problem.reactions()[static_cast<std::size_t>(row)];
  EXPECT_EQ(sample.mesh.communicator.sum(along_x), load * 3 * 8);  // nodes of 8 triangles
}

TEST(CoupledProblem, ConditionsReplaceRowsOfTheResidual) {
  Sample sample({});
  sample.problem.begin_step(0.5);
  auto x = sample.problem.guess();
  TpetraVector f(sample.problem.system().rows), magnitude(sample.problem.system().rows);
  sample.problem.residual(*x, f, magnitude);
  std::vector<char> is_held(static_cast<std::size_t>(sample.dofs.rows()), 0);
  for (const LocalIndex row : sample.held())
    is_held[static_cast<std::size_t>(row)] = is_held[static_cast<std::size_t>(row) + 1] = 1;
  const auto residual = f.getData();
  for (std::size_t row = 0; row < static_cast<std::size_t>(sample.dofs.owned()); ++row) {
    const double assembled = sample.problem.reactions()[row];
    EXPECT_GE(assembled, load);
    EXPECT_EQ(residual[static_cast<LocalIndex>(row)], is_held[row] ? 0 : assembled);
  }
}

/// Water whose cells remember, beside the load.
struct RememberingSample {
  Mesh mesh = sample_mesh();
  std::vector<PhysicsModule> modules = make_modules();
  FieldTable table = gather_fields(modules);
  DofMap dofs{mesh, table.fields};
  Assembler assembler{dofs, modules};
  Diagnostics diagnostics;
  Conditions conditions{
      assembler,
      table.rate_rules,
      conditions_of(R"(<prescribe field="velocity" on="water" value="x + t; y"/>)"),
      {},
      diagnostics};
  TimeIntegrator integrator;
  CoupledProblem problem{assembler, integrator, conditions};

  explicit RememberingSample(const TimeScheme& scheme = {})
      : integrator(assembler, table.rate_rules, scheme) {
    diagnostics.throw_if_any();
    conditions.set_initial(problem.state());
    problem.start();
  }
  static std::vector<PhysicsModule> make_modules() {
    std::vector<PhysicsModule> result;
    result.push_back(module_with(
        "flow", std::make_unique<RememberingKernel>("water", CellShape::triangle,
                                                    std::vector<FieldUse>{velocity(Role::adds)})));
    return result;
  }
  const CellMemory& memory() { return *assembler.memories()[0]; }
  void make_step(double step) {
    problem.begin_step(step);
    problem.finish_step(*problem.guess());
  }
};

TEST(CoupledProblem, CellsRememberAcceptedStepsAlone) {
  RememberingSample sample;
  sample.make_step(2);
  sample.make_step(1);  // the one of 2 s was rejected
  for (const double value : sample.memory().next)
    EXPECT_EQ(value, 0);
  sample.problem.accept();
  for (const double value : sample.memory().accepted)
    EXPECT_EQ(value, 0) << "what is evaluated after a step sees what its equations saw";
  const std::vector<double> after = sample.memory().next;
  for (std::size_t cell = 0; 2 * cell < after.size(); ++cell) {
    EXPECT_EQ(after[2 * cell], 1);
    double sum = 0;  // of the values at its three nodes: x + t and y
    for (std::size_t v = 0; v < 3; ++v) {
      const auto vertex = static_cast<std::size_t>(sample.memory().region->vertices[3 * cell + v]);
      sum += sample.mesh.coordinates[2 * vertex] + 1 + sample.mesh.coordinates[2 * vertex + 1];
    }
    EXPECT_NEAR(after[2 * cell + 1], sum, 1e-14);
  }
  sample.make_step(4);  // rejected
  sample.make_step(0.5);
  EXPECT_EQ(sample.memory().accepted, after);
  sample.problem.accept();
  EXPECT_EQ(sample.memory().next[0], 1.5);
}

// Time goes by from one instant of the equations to the next.
TEST(CoupledProblem, WhatIsRememberedStandsAtTheInstantOfTheEquations) {
  TimeScheme scheme;
  scheme.method = TimeScheme::Method::generalised_alpha;
  RememberingSample sample(scheme);
  for (int step = 0; step < 3; ++step) {
    sample.make_step(0.5);
    sample.problem.accept();
    EXPECT_NEAR(sample.memory().next[0], sample.problem.state().time, 1e-14);
  }
  EXPECT_LT(sample.problem.state().time, 1.5);
}

}  // namespace
}  // namespace hawser
