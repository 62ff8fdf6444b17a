#pragma once
// A deck that is stepped by hand: what the program does, with every number within reach.
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "ale_fluid.hpp"
#include "cable.hpp"
#include "hawser/physics/module_registry.hpp"
#include "mesh_motion.hpp"
#include "src/system.hpp"

namespace hawser {

class DeckRun {
 public:
  explicit DeckRun(const std::string& text) {
    Diagnostics diagnostics;
    const Deck parsed = parse_deck(text, "test.xml", diagnostics);
    deck_ = RunDeck::spec().read(parsed.root, diagnostics);
    if (deck_.time.steady()) deck_.time.step = std::min(deck_.time.step, deck_.time.end);
    ModuleRegistry registry;
    register_ale_fluid(registry);
    register_cable(registry);
    register_mesh_motion(registry);
    std::vector<PhysicsModule> modules;
    for (const DeckNode& node : deck_.modules.modules)
      modules.push_back(registry.find(node.tag)->make(node, {deck_.mesh.dimension()}, diagnostics));
    diagnostics.throw_if_any();
    const Communicator all;
    deck_.mesh.generate(all, "deck_run.msh");
    RunCase run{parsed, deck_, std::move(modules), {}};
    system_ = build_system(all, run, "deck_run.msh");
  }

  System& system() { return *system_; }
  const DofMap& dofs() const { return *system_->dofs; }
  /// Where the last step's equations stand, and its end.
  State& state() { return system_->problem->state(); }
  const State& end() const { return system_->problem->end(); }

  /// Other values or rates at the start than the deck's.
  void start_from(const State& initial) { system_->integrator->start(initial); }

  NonlinearReport step() { return step(deck_.time.step); }
  NonlinearReport step(double length) {
    CoupledProblem& problem = *system_->problem;
    problem.begin_step(length);
    const auto x = problem.guess();
    const NonlinearReport report = system_->driver->solve(*x);
    problem.finish_step(*x);
    problem.accept();
    return report;
  }

  /// Calls visit(row, X, d) for the first row of `field` at each of its nodes on a region, with the
  /// node's reference position and displacement.
  template <class Visit>
  void visit_nodes(const std::string& field, const std::string& region, Visit&& visit) {
    const int displacement = dofs().find("displacement");
    for (const LocalIndex row :
         dofs().region_rows(dofs().find(field), dofs().mesh().region(region))) {
      const RowInfo& info = dofs().info(row);
      const LocalIndex vertex =
          info.kind == PointKind::vertex
              ? info.point
              : dofs().mesh().vertex_of_split[static_cast<std::size_t>(info.point)];
      const LocalIndex moved = dofs().first_row(displacement, PointKind::vertex, vertex);
      double X[3];
      dofs().position(row, X);
      visit(row, X, &end().value[static_cast<std::size_t>(moved)]);
    }
  }

  /// Largest |value_c - expected(X, d)[c]| of a field on a region, over all ranks.
  template <class Expected>
  double deviation(const std::string& field, const std::string& region, Expected&& expected) {
    return deviation_of(end().value, field, region, expected);
  }
  template <class Expected>
  double deviation_of(const std::vector<double>& numbers, const std::string& field,
                      const std::string& region, Expected&& expected) {
    double worst = 0;
    const int components = dofs().fields()[static_cast<std::size_t>(dofs().find(field))].components;
    visit_nodes(field, region, [&](LocalIndex row, const double* X, const double* d) {
      const auto wanted = expected(X, d);
      for (int c = 0; c < components; ++c)
        worst = std::max(worst, std::abs(numbers[static_cast<std::size_t>(row + c)] -
                                         wanted[static_cast<std::size_t>(c)]));
    });
    return dofs().mesh().communicator.max(worst);
  }

 private:
  RunDeck deck_;
  std::unique_ptr<System> system_;
};

}  // namespace hawser
