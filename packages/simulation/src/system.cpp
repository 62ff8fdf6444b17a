#include "src/system.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "hawser/assembly/check_domains.hpp"
#include "hawser/assembly/connect_properties.hpp"
#include "hawser/fields/look_up.hpp"
#include "hawser/report/expectations.hpp"
#include "hawser/simulation/run_deck.hpp"
#include "src/take_over.hpp"

namespace hawser {
namespace {

/// At rest the row of a structure's displacement holds the velocity alone: an incomplete factor
/// meets a zero on the diagonal there.
void check_steady(const System& system, const LinearOptions& linear, double time,
                  const Location& where) {
  if (linear.method != LinearOptions::Method::gmres) return;
  State state = system.problem->state();
  state.time = time;
  state.step = std::numeric_limits<double>::infinity();
  std::vector<char> prescribed(static_cast<std::size_t>(system.dofs->owned()), 0);
  for (const PrescribedRow& row : system.conditions->prescribed(state, state))
    prescribed[static_cast<std::size_t>(row.row)] = 1;
  bool free = false;
  for (const auto& pair : system.assembler->kinematic_pairs())
    if (pair.displacement < system.dofs->owned())
      free = free || prescribed[static_cast<std::size_t>(pair.displacement)] == 0;
  if (system.mesh.communicator.any(free))
    throw DeckError(where.text() +
                    ": a steady solve that finds the place of a structure needs a complete factor: "
                    "<solver><linear method=\"mumps\"/></solver>");
}

std::vector<std::string> quantities_of(const RunDeck& deck, const Reports& reports) {
  std::vector<std::string> names = reports.quantities();
  if (deck.start.equilibrium) names.push_back("start_newton_iterations");
  names.push_back("wall_s");
  return names;
}

/// Jacobians are kept in time steps of systems that are large enough, and solved loosely enough,
/// for it to pay (doc/decisions/0064-kept-jacobians.md).
NonlinearOptions with_lagging(NonlinearOptions newton, bool steady, const DofMap& dofs) {
  constexpr GlobalIndex least_unknowns = 1000;
  constexpr double least_tolerance = 1e-8;
  newton.lagged = newton.lagged.value_or(!steady && newton.tolerance >= least_tolerance &&
                                         dofs.global_count() >= least_unknowns);
  return newton;
}

/// What does not fit together: DeckError, or notes.
void look_ahead(const Case& run_case, System& system, Diagnostics& diagnostics) {
  const RunDeck& deck = run_case.deck();
  const State& state = system.problem->state();
  const bool restarted = run_case.checkpoint() != nullptr;
  RunSpan span;
  span.begin = restarted ? run_case.checkpoint()->header().time : state.time;
  span.end = deck.time.end;
  span.first_step = deck.time.step;
  span.steady = deck.time.steady();
  span.finds_start = restarted || deck.start.from || deck.start.equilibrium;
  span.shortened = run_case.end().has_value();
  system.conditions->look_ahead(state, span, diagnostics);
  system.reports->look_ahead({span, state, *system.conditions}, diagnostics);
  if (const int every = deck.output.checkpoint_every;
      every > 0 && !span.steady && every * span.first_step > 1.001 * (span.end - span.begin))
    diagnostics.note(deck.output.location, "a checkpoint is asked for every " +
                                               std::to_string(every) + " steps, and in steps of " +
                                               write_value(span.first_step) +
                                               " s the run ends before the first one");
  diagnostics.throw_if_any();
  for (const std::string& note : diagnostics.notes())
    system.notes.push_back(note);
}

}  // namespace

std::unique_ptr<System> build_system(const Case& run_case, const std::string& mesh_file) {
  const RunDeck& deck = run_case.deck();
  auto system = std::make_unique<System>();
  system->modules = run_case.make_modules();
  system->mesh = read_mesh(run_case, mesh_file, domains_of(system->modules));
  system->notes = system->mesh.notes;
  Diagnostics diagnostics;
  check_domains(system->mesh, system->modules, diagnostics);
  diagnostics.throw_if_any();
  connect_properties(system->mesh, system->modules, diagnostics);
  diagnostics.throw_if_any();

  system->table = gather_fields(system->modules, deck.fields);
  system->dofs = std::make_unique<DofMap>(system->mesh, system->table.fields);
  system->assembler = std::make_unique<Assembler>(*system->dofs, system->modules);
  const NamedSources named{make_tracks(deck.tracks, diagnostics), deck.tables};
  check_names(deck.tables, diagnostics);
  system->conditions = std::make_unique<Conditions>(*system->assembler, system->table.rate_rules,
                                                    deck.conditions, named, diagnostics);
  system->reports = std::make_unique<Reports>(
      run_case.reports(),
      ReportContext{*system->assembler, system->modules, system->table.rate_rules, named.tracks},
      diagnostics);
  if (diagnostics.ok())
    check_expectations(deck.expectations, quantities_of(deck, *system->reports), diagnostics);
  diagnostics.throw_if_any();

  system->integrator = std::make_unique<TimeIntegrator>(
      *system->assembler, system->table.rate_rules, deck.time.scheme());
  system->problem = std::make_unique<CoupledProblem>(*system->assembler, *system->integrator,
                                                     *system->conditions);
  system->conditions->set_initial(system->problem->state());
  if (!run_case.checkpoint() && deck.start.from) take_over(run_case, *system);
  look_ahead(run_case, *system, diagnostics);
  system->problem->start();
  const auto& reports = system->reports->all();
  if (deck.time.energy_growth > 0 || std::any_of(reports.begin(), reports.end(), [](const auto& r) {
        return r->looks_at_energy();
      })) {
    system->energy = std::make_unique<EnergyLedger>(*system->assembler);
    system->energy->start(system->problem->state());
  }
  if (deck.time.steady())
    check_steady(*system, deck.solver.linear, deck.time.end, deck.time.location);
  else if (deck.start.equilibrium)
    check_steady(*system, deck.solver.linear, system->problem->state().time, deck.start.location);
  system->driver = std::make_unique<NonlinearDriver>(
      *system->problem, deck.solver.linear,
      with_lagging(deck.solver.newton, deck.time.steady(), *system->dofs));
  system->driver->describe_row(
      [dofs = system->dofs.get()](GlobalIndex row) { return describe_row(*dofs, row); });
  return system;
}

std::string describe_row(const DofMap& dofs, GlobalIndex global_row) {
  const auto begin = dofs.global_rows().begin();
  const auto found = std::find(begin, begin + dofs.owned(), global_row);
  if (found == begin + dofs.owned()) return "row " + std::to_string(global_row);
  const auto row = static_cast<LocalIndex>(found - begin);
  const RowInfo& info = dofs.info(row);
  const FieldDescription& field = dofs.fields()[static_cast<std::size_t>(info.field)];
  double position[3] = {0, 0, 0};
  dofs.position(row, position);
  std::ostringstream text;
  text << field.name;
  if (field.components > 1) text << ' ' << static_cast<char>('x' + info.component);
  text << " at the node that started at (" << position[0];
  for (int j = 1; j < dofs.mesh().dimension; ++j)
    text << ", " << position[j];
  text << ") m";
  return text.str();
}

}  // namespace hawser
