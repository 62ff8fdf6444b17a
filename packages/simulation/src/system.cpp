#include "src/system.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "hawser/assembly/check_domains.hpp"
#include "hawser/fields/look_up.hpp"
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

}  // namespace

std::unique_ptr<System> build_system(const Case& run_case, const std::string& mesh_file) {
  const RunDeck& deck = run_case.deck();
  auto system = std::make_unique<System>();
  system->modules = run_case.make_modules();
  system->mesh = read_mesh(run_case, mesh_file, domains_of(system->modules));
  Diagnostics diagnostics;
  check_domains(system->mesh, system->modules, diagnostics);
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
  diagnostics.throw_if_any();

  system->integrator = std::make_unique<TimeIntegrator>(
      *system->assembler, system->table.rate_rules, deck.time.scheme());
  system->problem = std::make_unique<CoupledProblem>(*system->assembler, *system->integrator,
                                                     *system->conditions);
  system->conditions->set_initial(system->problem->state());
  if (!run_case.checkpoint() && deck.start.from) take_over(run_case, *system);
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
  system->driver =
      std::make_unique<NonlinearDriver>(*system->problem, deck.solver.linear, deck.solver.newton);
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
