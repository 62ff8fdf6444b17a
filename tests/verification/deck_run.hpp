#pragma once
// A deck that is stepped by hand, with every number within reach.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "hawser/base/error.hpp"
#include "hawser/simulation/stepper.hpp"
#include "src/system.hpp"

namespace hawser {

class DeckRun {
 public:
  explicit DeckRun(const std::string& text) : stepper_(Case::from_text(environment_, text)) {}

  System& system() { return stepper_.system(); }
  const DofMap& dofs() const { return *stepper_.system().dofs; }
  /// Where the last step's equations stand, and its end.
  State& state() { return system().problem->state(); }
  const State& end() const { return stepper_.system().problem->end(); }

  /// Other values or rates at the start than the deck's.
  void start_from(const State& initial) { system().integrator->start(initial); }

  NonlinearReport step(double longest = std::numeric_limits<double>::infinity()) {
    const Attempt attempt = stepper_.advance(longest);
    if (!attempt.accepted) throw SolveError(attempt.why);
    return attempt.newton;
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
  Environment environment_;
  Stepper stepper_;
};

}  // namespace hawser
