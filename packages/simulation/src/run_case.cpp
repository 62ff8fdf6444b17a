#include "src/run_case.hpp"

#include "hawser/base/error.hpp"
#include "hawser/simulation/deck_language.hpp"

namespace hawser {
namespace {

void load_plugins(const Communicator& communicator, const std::vector<PluginDeck>& plugins,
                  const std::string& folder, Registries& registries) {
  for (const PluginDeck& plugin : plugins)
    communicator.together([&] {
      try {
        load_plugin(plugin.name.value, folder, registries);
      } catch (const PluginError& error) {
        throw PluginError(plugin.name.location.text() + ": " + error.what());
      }
    });
}

std::vector<PhysicsModule> make_modules(const DeckNode& root, const RunDeck& deck,
                                        const ModuleRegistry& registry, Diagnostics& diagnostics) {
  std::vector<PhysicsModule> modules;
  for (const DeckNode& node : deck.modules.modules) {
    if (!is_known_child(node, "modules", registry.tags(), diagnostics)) continue;
    modules.push_back(registry.find(node.tag)->make(node, {deck.mesh.dimension()}, diagnostics));
    modules.back().location = node.location;
  }
  if (modules.empty() && diagnostics.ok())
    diagnostics.error(root.find_child("modules")->location,
                      "<modules> is empty; there are " + listed(registry.tags()));
  return modules;
}

std::vector<PlannedReport> plan_reports(const RunDeck& deck, const ReportRegistry& registry,
                                        Diagnostics& diagnostics) {
  auto reports = registry.read(deck.reports, RunDeck::spec().node_spec(), diagnostics);
  for (PlannedReport& report :
       registry.read(deck.output.reports, OutputDeck::spec().node_spec(), diagnostics))
    reports.push_back(std::move(report));
  return reports;
}

}  // namespace

RunCase read_case(const Communicator& communicator, Deck text, const RunOptions& options,
                  Registries& registries, Diagnostics& diagnostics) {
  RunCase run;
  run.text = std::move(text);
  run.deck = RunDeck::spec().read(run.text.root, diagnostics);
  if (!options.expects) run.deck.expectations.clear();
  TimeDeck& time = run.deck.time;
  if (options.end) time.end = *options.end;
  if (time.steady()) time.step = std::min(time.step, time.end);
  if (time.least == 0) time.least = time.step / 1000;
  time.order = time.scheme().order();
  for (auto* conditions : {&run.deck.conditions.initial, &run.deck.conditions.prescribe})
    for (ConditionDeck& condition : *conditions)
      if (condition.table) condition.table->value = path_beside(run.text, *condition.table);
  load_plugins(communicator, run.deck.plugins, options.plugin_folder, registries);
  run.modules = make_modules(run.text.root, run.deck, registries.modules, diagnostics);
  run.reports = plan_reports(run.deck, registries.reports, diagnostics);
  diagnostics.throw_if_any();
  return run;
}

std::string resolved(const Deck& deck, const Registries& registries) {
  return resolved_deck(deck.root, deck_language(registries));
}

ProvidedMesh provide_mesh(const Communicator& communicator, const RunCase& run,
                          const std::string& place) {
  const MeshDeck& mesh = run.deck.mesh;
  if (mesh.file) return {path_beside(run.text, mesh.file->name), {}};
  return {place, mesh.generate(communicator, place)};
}

}  // namespace hawser
