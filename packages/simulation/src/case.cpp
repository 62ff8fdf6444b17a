#include "hawser/simulation/case.hpp"

#include <filesystem>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/simulation/deck_language.hpp"
#include "hawser/simulation/run_deck.hpp"

namespace hawser {
namespace {

void load_plugins(const Environment& environment, const std::vector<PluginDeck>& plugins,
                  Registries& registries) {
  for (const PluginDeck& plugin : plugins)
    environment.communicator().together([&] {
      try {
        load_plugin(plugin.name.value, environment.plugin_folder, registries);
      } catch (const PluginError& error) {
        throw PluginError(plugin.name.location.text() + ": " + error.what());
      }
    });
}

std::vector<PhysicsModule> modules_of(const Deck& text, const RunDeck& deck,
                                      const ModuleRegistry& registry, Diagnostics& diagnostics) {
  std::vector<PhysicsModule> modules;
  for (const DeckNode& node : deck.modules.modules) {
    if (!is_known_child(node, "modules", registry.tags(), diagnostics)) continue;
    modules.push_back(registry.find(node.tag)->make(node, {deck.mesh.dimension()}, diagnostics));
    modules.back().location = node.location;
  }
  if (modules.empty() && diagnostics.ok())
    diagnostics.error(text.root.find_child("modules")->location,
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

/// What the parameters leave to each other.
void complete(RunDeck& deck, const Deck& text, const CaseOptions& options) {
  if (!options.expects) deck.expectations.clear();
  TimeDeck& time = deck.time;
  if (options.end) time.end = *options.end;
  if (time.steady()) time.step = std::min(time.step, time.end);
  if (time.least == 0) time.least = time.step / 1000;
  time.order = time.scheme().order();
  for (TableDeck& table : deck.tables)
    table.file.value = path_beside(text, table.file);
  for (auto* conditions : {&deck.conditions.initial, &deck.conditions.prescribe})
    for (ConditionDeck& condition : *conditions)
      condition.complete_sources(text);
}

}  // namespace

struct Case::Content {
  Communicator communicator;
  Registries registries;  // with the deck's plug-ins
  Deck text;
  RunDeck deck;
  std::vector<PlannedReport> reports{};
  std::unique_ptr<CheckpointReader> checkpoint{};
  std::string home{};
  std::optional<double> end{}, end_of_deck{};
};

Case::Case(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

std::shared_ptr<Case::Content> Case::read(const Environment& environment, Deck text,
                                          const CaseOptions& options, Diagnostics& diagnostics) {
  auto content = std::make_shared<Content>(
      Content{environment.communicator(), environment.registries, std::move(text), RunDeck()});
  content->end = options.end;
  content->deck = RunDeck::spec().read(content->text.root, diagnostics);
  const double end = content->deck.time.end;
  if (options.end && *options.end < end) content->end_of_deck = end;
  complete(content->deck, content->text, options);
  load_plugins(environment, content->deck.plugins, content->registries);
  modules_of(content->text, content->deck, content->registries.modules, diagnostics);
  content->reports = plan_reports(content->deck, content->registries.reports, diagnostics);
  const auto& equilibrium = content->deck.start.equilibrium;
  if (equilibrium && equilibrium->continuation)
    equilibrium->continuation->check(content->text.root.names.get(), diagnostics);
  diagnostics.throw_if_any();
  return content;
}

Case Case::from_file(const Environment& environment, const std::string& deck,
                     const CaseOptions& options) {
  Diagnostics diagnostics;
  return Case(read(environment,
                   read_deck(environment.communicator(), deck, options.changes,
                             deck_language(environment.registries), diagnostics),
                   options, diagnostics));
}

Case Case::from_text(const Environment& environment, const std::string& text,
                     const std::string& name, const CaseOptions& options) {
  Diagnostics diagnostics;
  return Case(read(environment,
                   read_deck_text(environment.communicator(), text, name, options.changes,
                                  deck_language(environment.registries), diagnostics),
                   options, diagnostics));
}

Case Case::from_checkpoint(const Environment& environment, const std::string& file,
                           const CaseOptions& options) {
  if (!options.changes.empty())
    throw Error(ExitCode::usage, file +
                                     ": the deck in a checkpoint stays as it is; the end alone "
                                     "may be another");
  auto checkpoint = std::make_unique<CheckpointReader>(environment.communicator(), file);
  const CheckpointHeader& header = checkpoint->header();
  Diagnostics diagnostics;
  const auto content = read(
      environment, parse_deck(header.texts.at("deck"), header.texts.at("deck_file"), diagnostics),
      options, diagnostics);
  const TimeDeck& time = content->deck.time;
  if (StepControl(time, {}).finished(header.time))
    throw Error(ExitCode::usage, file + " is at t = " + write_value(header.time) +
                                     " s, and the run ends at " + write_value(time.end) +
                                     " s: nothing is left to do; --end sets a later end");
  content->checkpoint = std::move(checkpoint);
  content->home = std::filesystem::absolute(file).parent_path().string();
  return Case(content);
}

Case Case::changed(const std::vector<DeckChange>& changes) const {
  Diagnostics diagnostics;
  auto content = std::make_shared<Content>(
      Content{communicator(), content_->registries,
              read_deck_text(communicator(), text().text, text().file, changes,
                             deck_language(content_->registries), diagnostics),
              RunDeck()});
  content->end = content_->end;
  content->deck = RunDeck::spec().read(content->text.root, diagnostics);
  complete(content->deck, content->text, {{}, content->end, false});
  modules_of(content->text, content->deck, content->registries.modules, diagnostics);
  content->reports = plan_reports(content->deck, content->registries.reports, diagnostics);
  diagnostics.throw_if_any();
  return Case(content);
}

const Communicator& Case::communicator() const { return content_->communicator; }
const Deck& Case::text() const { return content_->text; }
const RunDeck& Case::deck() const { return content_->deck; }
const CheckpointReader* Case::checkpoint() const { return content_->checkpoint.get(); }
const std::string& Case::home() const { return content_->home; }
std::optional<double> Case::end() const { return content_->end; }
std::optional<double> Case::end_of_deck() const { return content_->end_of_deck; }
bool Case::has_mesh_file() const { return deck().mesh.file.has_value(); }

std::string Case::resolved_deck() const {
  return hawser::resolved_deck(text().root, deck_language(content_->registries));
}

std::vector<PhysicsModule> Case::make_modules() const {
  Diagnostics diagnostics;
  return modules_of(text(), deck(), content_->registries.modules, diagnostics);
}

const std::vector<PlannedReport>& Case::reports() const { return content_->reports; }

ProvidedMesh provide_mesh(const Case& run_case, const std::string& place) {
  const MeshDeck& mesh = run_case.deck().mesh;
  // A restarted run uses the very mesh of the run that it continues.
  if (const CheckpointReader* const checkpoint = run_case.checkpoint())
    return {
        (std::filesystem::path(run_case.home()) / checkpoint->header().texts.at("mesh")).string(),
        {}};
  if (mesh.file) return {path_beside(run_case.text(), mesh.file->name), {}};
  try {
    return {place, mesh.generate(run_case.communicator(), place)};
  } catch (const MeshError& error) {
    throw MeshError(mesh.location.text() + ": " + error.what());
  }
}

Mesh read_mesh(const Case& run_case, const std::string& file, std::vector<Domain> domains) {
  const MeshDeck& deck = run_case.deck().mesh;
  try {
    return read_mesh(run_case.communicator(), {file, deck.slits, deck.dimension(),
                                               std::move(domains), deck.apart, deck.open_boundary});
  } catch (const MeshError& error) {
    std::string text;
    std::istringstream faults(error.what());
    for (std::string fault; std::getline(faults, fault);)
      text += (text.empty() ? "" : "\n") + deck.location.text() + ": " + fault;
    throw MeshError(text);
  }
}

}  // namespace hawser
