#include "hawser/simulation/case.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "hawser/assembly/connect_properties.hpp"
#include "hawser/base/error.hpp"
#include "hawser/simulation/deck_language.hpp"
#include "hawser/simulation/run_deck.hpp"
#include "hawser/values/curve.hpp"
#include "src/kept_case.hpp"
#include "src/plugins.hpp"
#include "src/uniform_motion.hpp"

namespace hawser {
namespace {

std::vector<PlannedReport> plan_reports(const RunDeck& deck, const ReportRegistry& registry,
                                        Diagnostics& diagnostics) {
  auto reports = registry.read(deck.reports, RunDeck::spec().node_spec(), diagnostics);
  for (PlannedReport& report :
       registry.read(deck.output.reports, OutputDeck::spec().node_spec(), diagnostics))
    reports.push_back(std::move(report));
  return reports;
}

/// Lays the cable along its shape. Collective.
void lay_along_shape(LineMesh& line, const Deck& text, Diagnostics& diagnostics) {
  const std::string path = path_beside(text, line.shape);
  const Location& where = line.shape.location;
  constexpr std::size_t largest = 16U << 20U;  // bytes
  const auto read = text.files->read(path, largest);
  line.dimension = 2;
  if (!read || read->size() > largest)
    return diagnostics.error(
        where, (read ? "larger than 16 MB: the shape " : "cannot read the shape ") + path);
  const std::size_t before = diagnostics.error_count();
  const Curve curve = read_curve(*read, path, diagnostics);
  if (diagnostics.error_count() > before) return;
  line.dimension = curve.dimension;
  const double along = curve.arc_lengths.empty() ? curve.length() : curve.arc_lengths.back();
  const std::string wrong = lay_line(curve.points, curve.dimension,
                                     line.cable_length.value_or(along), line.segments, line.nodes);
  if (!wrong.empty()) diagnostics.error(where, wrong);
}

/// What the parameters leave to each other. Collective.
void complete(RunDeck& deck, const Deck& text, const CaseOptions& options,
              Diagnostics& diagnostics) {
  if (deck.mesh.line && !deck.mesh.line->shape->empty())
    lay_along_shape(*deck.mesh.line, text, diagnostics);
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
  std::vector<DeckChange> changes{};
  std::unique_ptr<CheckpointReader> checkpoint{};
  std::string home{}, damage{};
  std::optional<double> end{}, end_of_deck{};
  PluginOfTag plugins{};

  std::vector<PhysicsModule> make_modules(Diagnostics& diagnostics) const {
    std::vector<PhysicsModule> modules =
        hawser::make_modules(text, deck, registries.modules, plugins, diagnostics);
    if (diagnostics.ok()) resolve_properties(modules, diagnostics);
    return modules;
  }
};

Case::Case(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

std::shared_ptr<Case::Content> Case::read(const Environment& environment,
                                          const std::shared_ptr<InputFiles>& files,
                                          const std::string& deck, std::vector<DeckChange> changes,
                                          const CaseOptions& options) {
  Diagnostics diagnostics;
  Deck text = read_deck(files, deck, changes, deck_language(environment.registries), diagnostics);
  auto content = std::make_shared<Content>(
      Content{environment.communicator(), environment.registries, std::move(text), RunDeck()});
  content->changes = std::move(changes);
  content->end = options.end;
  content->deck = RunDeck::spec().read(content->text.root, diagnostics);
  const double end = content->deck.time.end;
  if (options.end && *options.end < end) content->end_of_deck = end;
  if (options.end) set_end(content->text.root, *options.end);
  complete(content->deck, content->text, options, diagnostics);
  const Communicator& communicator = environment.communicator();
  const std::vector<PluginDeck>& plugins = content->deck.plugins;
  rehearse_plugins(communicator, environment.plugin_folder, plugins, content->registries,
                   &content->text, &content->deck);
  content->plugins =
      load_plugins(communicator, environment.plugin_folder, plugins, content->registries);
  communicator.together([&] { content->make_modules(diagnostics); });
  content->reports = plan_reports(content->deck, content->registries.reports, diagnostics);
  const auto& equilibrium = content->deck.start.equilibrium;
  check_uniform_motion(content->deck, diagnostics);
  if (equilibrium && equilibrium->continuation)
    equilibrium->continuation->check(content->text.root.names.get(), diagnostics);
  diagnostics.throw_if_any();
  return content;
}

Case Case::from_file(const Environment& environment, const std::string& deck,
                     const CaseOptions& options) {
  return Case(read(environment, std::make_shared<InputFiles>(environment.communicator()), deck,
                   options.changes, options));
}

Case Case::from_text(const Environment& environment, const std::string& text,
                     const std::string& name, const CaseOptions& options) {
  InputFiles::Kept given = {{name, {"", text}}};
  return Case(read(environment,
                   std::make_shared<InputFiles>(environment.communicator(), std::move(given)), name,
                   options.changes, options));
}

Case Case::from_checkpoint(const Environment& environment, const std::string& file,
                           const CaseOptions& options) {
  Diagnostics diagnostics;
  check_restart(options.changes, diagnostics);
  diagnostics.throw_if_any();
  OpenedCheckpoint checkpoint = open_checkpoint(environment.communicator(), file);
  const CheckpointHeader& header = checkpoint.reader->header();
  CaseOptions now = options;
  const auto end = header.numbers.find("end_s");
  if (!now.end && end != header.numbers.end() && !sets_end(options.changes)) now.end = end->second;
  const auto content =
      read(environment,
           std::make_shared<InputFiles>(environment.communicator(), kept_files(*checkpoint.reader)),
           header.texts.at("deck_file"), joined(kept_changes(header), options.changes), now);
  const TimeDeck& time = content->deck.time;
  if (StepControl(time, {}).finished(header.time))
    throw Error(ExitCode::usage, checkpoint.reader->path() +
                                     " is at t = " + write_value(header.time) +
                                     " s, and the run ends at " + write_value(time.end) +
                                     " s: nothing is left to do; --end sets a later end");
  content->checkpoint = std::move(checkpoint.reader);
  content->damage = checkpoint.damage;
  content->home = std::filesystem::absolute(file).parent_path().string();
  return Case(content);
}

Case Case::changed(const std::vector<DeckChange>& changes) const {
  Diagnostics diagnostics;
  auto content = std::make_shared<Content>(
      Content{communicator(), content_->registries,
              read_deck(text().files, text().file, joined(content_->changes, changes),
                        deck_language(content_->registries), diagnostics),
              RunDeck()});
  content->end = content_->end;
  content->deck = RunDeck::spec().read(content->text.root, diagnostics);
  complete(content->deck, content->text, {{}, content->end, false}, diagnostics);
  content->plugins = content_->plugins;
  content->make_modules(diagnostics);
  content->reports = plan_reports(content->deck, content->registries.reports, diagnostics);
  diagnostics.throw_if_any();
  return Case(content);
}

void Case::save(CheckpointHeader& header, std::vector<KeptFile>& files) const {
  header.texts["deck_file"] = text().file;
  keep_changes(content_->changes, header);
  if (end()) header.numbers["end_s"] = *end();
  files = files_to_keep(text().files->kept());
}

const std::string& Case::damage() const { return content_->damage; }
const Communicator& Case::communicator() const { return content_->communicator; }
const Deck& Case::text() const { return content_->text; }
const RunDeck& Case::deck() const { return content_->deck; }
const CheckpointReader* Case::checkpoint() const { return content_->checkpoint.get(); }
const std::string& Case::home() const { return content_->home; }
std::optional<double> Case::end() const { return content_->end; }
std::optional<double> Case::end_of_deck() const { return content_->end_of_deck; }
bool Case::has_mesh_file() const { return deck().mesh.file.has_value(); }
bool Case::has_line_mesh() const { return deck().mesh.line || deck().mesh.lines; }

std::string Case::resolved_deck() const {
  return hawser::resolved_deck(text().root, deck_language(content_->registries));
}

std::vector<PhysicsModule> Case::make_modules() const {
  Diagnostics diagnostics;
  return content_->make_modules(diagnostics);
}

const std::vector<PlannedReport>& Case::reports() const { return content_->reports; }

ProvidedMesh provide_mesh(const Case& run_case, const std::string& place) {
  const MeshDeck& mesh = run_case.deck().mesh;
  if (run_case.checkpoint()) {  // the very mesh of the run that goes on
    ProvidedMesh kept{"", "", std::make_shared<ScratchFolder>(run_case.communicator())};
    kept.file = kept.scratch->path() + "/mesh.msh";
    run_case.communicator().on_root([&] {
      std::ofstream file(kept.file, std::ios::binary);
      file << run_case.text().files->kept().at(kept_mesh).text;
      if (!file.flush()) throw OutputError("cannot write " + kept.file);
    });
    return kept;
  }
  if (mesh.file) return {path_beside(run_case.text(), mesh.file->name), {}};
  try {
    const std::string geometry = mesh.geo ? path_beside(run_case.text(), mesh.geo->file) : "";
    return {place, mesh.generate(run_case.communicator(), geometry, place)};
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
