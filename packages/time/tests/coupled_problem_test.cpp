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
    EXPECT_NEAR(sample.problem.end().value[r], 4, 1e-14);                  // 3 + 2*0.5
    EXPECT_NEAR(sample.problem.state().value[r], 1 + alpha_f * 3, 1e-14);  // between 1 and 4
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

}  // namespace
}  // namespace hawser
