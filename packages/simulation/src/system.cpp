#include "src/system.hpp"

#include <algorithm>
#include <sstream>

#include "hawser/fields/look_up.hpp"

namespace hawser {
namespace {

std::string base_name(const std::string& region) { return region.substr(0, region.find('/')); }

void check_regions(const Mesh& mesh, const std::vector<PhysicsModule>& modules,
                   Diagnostics& diagnostics) {
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels) {
      if (kernel->dimension() != mesh.dimension) {
        diagnostics.error(module.location, "module '" + module.name + "' is written for " +
                                               std::to_string(kernel->dimension()) +
                                               " dimensions, the mesh has " +
                                               std::to_string(mesh.dimension));
        break;
      }
      const std::string base = base_name(kernel->region());
      if (base == kernel->region()) {
        find_region_of(kernel->shapes(), mesh, {base, module.location},
                       "module '" + module.name + "'", diagnostics);
        continue;
      }
      if (mesh.find(kernel->region()) != nullptr) continue;
      if (find_region(mesh, base, module.location, diagnostics) == nullptr) continue;
      const std::string part = kernel->region().substr(base.size() + 1);
      if (part == "facets")
        diagnostics.error(module.location,
                          "region '" + base + "' is no line on the boundary of the body");
      else if (part == "patches")
        diagnostics.error(module.location, "region '" + base +
                                               "' is no line inside the body or of at least two "
                                               "segments");
      else if (find_region(mesh, part, module.location, diagnostics) != nullptr)
        diagnostics.error(module.location, "'" + part + "' is no point of region '" + base + "'");
    }
}

Probe make_probe(const DofMap& dofs, const ProbeDeck& deck, Diagnostics& diagnostics) {
  Probe probe{deck.name, deck.field.value, "", 1, -1};
  const Region* const point =
      find_point(dofs.mesh(), deck.on, "probe '" + deck.name + "'", diagnostics);
  const int field = find_field(dofs, deck.field, diagnostics);
  if (field < 0) return probe;
  probe.unit = dofs.fields()[static_cast<std::size_t>(field)].unit;
  probe.components = dofs.fields()[static_cast<std::size_t>(field)].components;
  if (point == nullptr) return probe;
  const std::vector<LocalIndex> rows = dofs.region_rows(field, *point);
  if (!rows.empty() && rows.front() < dofs.owned()) probe.first_row = rows.front();
  return probe;
}

/// At rest the row of a structure's displacement holds the velocity alone: an incomplete factor
/// meets a zero on the diagonal there.
void check_steady(const System& system, const RunDeck& deck) {
  if (!deck.time.steady() || deck.solver.linear.method != LinearOptions::Method::gmres) return;
  system.problem->begin_step(deck.time.end);
  std::vector<char> prescribed(static_cast<std::size_t>(system.dofs->owned()), 0);
  for (const PrescribedRow& row :
       system.conditions->prescribed(system.problem->state(), system.problem->end()))
    prescribed[static_cast<std::size_t>(row.row)] = 1;
  bool free = false;
  for (const auto& pair : system.assembler->kinematic_pairs())
    if (pair.displacement < system.dofs->owned())
      free = free || prescribed[static_cast<std::size_t>(pair.displacement)] == 0;
  if (system.mesh.communicator.any(free))
    throw DeckError(deck.time.location.text() +
                    ": a steady solve that finds the place of a structure needs a complete factor: "
                    "<solver><linear method=\"mumps\"/></solver>");
}

}  // namespace

std::unique_ptr<System> build_system(const Communicator& communicator, const RunDeck& deck,
                                     std::vector<PhysicsModule> modules,
                                     const std::string& mesh_file) {
  auto system = std::make_unique<System>(
      System{read_mesh(communicator, {mesh_file, deck.mesh.slits, deck.mesh.dimension()}),
             std::move(modules),
             {},
             {},
             {},
             {},
             {},
             {},
             {},
             {},
             {},
             {},
             {},
             {}});
  Diagnostics diagnostics;
  check_regions(system->mesh, system->modules, diagnostics);
  diagnostics.throw_if_any();

  system->table = gather_fields(system->modules, deck.fields);
  system->dofs = std::make_unique<DofMap>(system->mesh, system->table.fields);
  system->assembler = std::make_unique<Assembler>(*system->dofs, system->modules);
  const Tracks tracks = make_tracks(deck.tracks, diagnostics);
  system->conditions = std::make_unique<Conditions>(*system->assembler, system->table.rate_rules,
                                                    deck.conditions, tracks, diagnostics);
  if (deck.tow)
    system->tow = std::make_unique<TowReport>(*system->dofs, *deck.tow, tracks, diagnostics);
  for (const ForceDeck& force : deck.forces)
    system->forces.emplace_back(*system->assembler, system->modules, force, diagnostics);
  for (const ProbeDeck& probe : deck.output.probes)
    system->probes.push_back(make_probe(*system->dofs, probe, diagnostics));
  for (const ErrorDeck& error : deck.errors)
    system->errors.emplace_back(*system->dofs, error, diagnostics);
  diagnostics.throw_if_any();
  if (deck.tow && deck.tow->receivers)
    system->receivers =
        std::make_unique<Receivers>(*system->assembler, *system->tow, *deck.tow->receivers);

  system->integrator = std::make_unique<TimeIntegrator>(
      *system->assembler, system->table.rate_rules, deck.time.scheme());
  system->problem = std::make_unique<CoupledProblem>(*system->assembler, *system->integrator,
                                                     *system->conditions);
  system->conditions->set_initial(system->problem->state());
  system->problem->start();
  check_steady(*system, deck);
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
