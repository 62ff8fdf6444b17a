#include "src/continuation.hpp"

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/simulation/run_deck.hpp"

namespace hawser {
namespace {

constexpr int quick = 6;                    // iterations: the next step is twice as long
constexpr double least_share = 1.0 / 4096;  // of the first step

/// The parameter's values, from s = 0 to its own at s = 1.
struct Way {
  std::string name, unit;
  double from = 0, to = 0;  // in `unit`
  bool geometric = false;

  Way(const ContinuationDeck& deck, const NamedValues* parameters)
      : name(deck.parameter.value), geometric(deck.geometric) {
    const NamedValue& own = *find_named(parameters, name);
    if (own.unit) unit = " " + own.unit->text;
    to = own.given;
    from = deck.from.value({}) / (own.unit ? own.unit->factor : 1);
  }
  std::string text(double s) const {
    const double value = geometric ? from * std::pow(to / from, s) : from + s * (to - from);
    return write_value(value) + unit;
  }
};

/// The states that were found last.
struct Trail {
  std::vector<double> value, earlier;  // per local row
  double s = 0, earlier_s = 0;

  void add(double where, const std::vector<double>& found) {
    earlier = std::move(value);
    earlier_s = s;
    value = found;
    s = where;
  }
  std::vector<double> guess(double where) const {
    std::vector<double> result = value;
    if (earlier.empty()) return result;
    const double share = (where - s) / (s - earlier_s);
    for (std::size_t row = 0; row < result.size(); ++row)
      result[row] += share * (value[row] - earlier[row]);
    return result;
  }
};

}  // namespace

State continue_equilibrium(const Case& run_case, const std::string& mesh_file, System& system,
                           const EquilibriumOptions& options,
                           const std::function<void(const StartSolve&)>& tell) {
  const ContinuationDeck& deck = *run_case.deck().start.equilibrium->continuation;
  const Way way(deck, run_case.text().root.names.get());
  EquilibriumOptions stepping = options;
  stepping.relaxes = false;
  int iterations = 0;
  const auto find = [&](double s, System& there, const EquilibriumOptions& how) {
    return find_equilibrium(there, how, [&](StartSolve solve) {
      solve.what += ", " + way.name + " = " + way.text(s);
      iterations = solve.newton.iterations;
      tell(solve);
    });
  };
  const auto built = [&](double s) {
    return build_system(run_case.changed({{way.name, way.text(s)}}), mesh_file);
  };
  Trail trail;
  trail.add(0, find(0, *built(0), options).value);
  const double first = 1.0 / deck.steps;
  for (double step = first;;) {
    const double s = trail.s + step > 1 - 1e-9 ? 1 : trail.s + step;
    const std::unique_ptr<System> other = s < 1 ? built(s) : nullptr;
    System& there = other ? *other : system;
    std::vector<double> guess = trail.guess(s);
    if (guess.size() != there.problem->state().value.size())
      throw DeckError(deck.parameter.location.text() + ": with another value of '" + way.name +
                      "' the run has other unknowns; no state leads from one to the other");
    there.problem->state().value = std::move(guess);
    try {
      State found = find(s, there, stepping);
      if (s == 1) return found;
      trail.add(s, found.value);
      if (iterations <= quick) step *= 2;
    } catch (const SolveError& error) {
      step /= 2;
      if (step < least_share * first)
        throw SolveError("no steady state was found beyond " + way.name + " = " +
                         way.text(trail.s) + ": " + error.what());
    }
  }
}

}  // namespace hawser
