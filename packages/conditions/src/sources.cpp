#include "hawser/conditions/sources.hpp"

#include "hawser/base/error.hpp"
#include "hawser/conditions/conditions_deck.hpp"
#include "hawser/values/expression_source.hpp"
#include "hawser/values/table.hpp"

namespace hawser {
namespace {

/// The same text on all ranks; without the deck's files, as it lies on disk.
std::string read_table(const Communicator& communicator, const std::shared_ptr<InputFiles>& files,
                       const std::string& path) {
  constexpr std::size_t largest = 256U << 20U;  // bytes; millions of rows
  const auto text =
      files ? files->read(path, largest) : InputFiles(communicator).read(path, largest);
  if (!text) throw DeckError("cannot read the table " + path);
  if (text->size() > largest)
    throw DeckError("the table " + path + " is larger than the allowed 256 MB");
  return *text;
}

/// A track in space: level.
class LevelTrack : public ValueSource {
 public:
  explicit LevelTrack(std::shared_ptr<const Track> track) : track_(std::move(track)) {}
  int components() const override { return 3; }
  void value(const SpaceTime& at, double* values) const override {
    track_->value(at, values);
    values[2] = 0;
  }
  void time_derivative(const SpaceTime& at, double* rates) const override {
    track_->time_derivative(at, rates);
    rates[2] = 0;
  }
  void gradient(const SpaceTime& at, int component, double* slope) const override {
    track_->gradient(at, component, slope);
  }
  bool depends_on_moved_position(int) const override { return false; }
  using ValueSource::depends_on_moved_position;

 private:
  std::shared_ptr<const Track> track_;
};

}  // namespace

Spec<ConditionDeck> FormulaSource::declare(Spec<ConditionDeck> spec) {
  return std::move(spec).attribute(
      attribute, &FormulaSource::given, "SI", any() && absent("table or track says it"),
      "A number or expression per component, of x y z (moved), X Y Z (reference), t.");
}

std::shared_ptr<const ValueSource> FormulaSource::make(const SourceContext&) const {
  return std::make_shared<ExpressionSource>(given->value);
}

Spec<ConditionDeck> TableSource::declare(Spec<ConditionDeck> spec) {
  return std::move(spec).attribute(
      attribute, &TableSource::given, absent("no table"),
      "Name of a <table>, or a CSV file whose columns are named by quantity and unit: time_s, x_m, "
      "y_m, z_m and velocity_x_m_per_s or whatever the field is. Linear between its rows. A "
      "relative path starts at the deck's folder.");
}

void TableSource::complete(const Deck& text) {
  if (given) file = path_beside(text, *given);
  files = text.files;
}

std::shared_ptr<const ValueSource> TableSource::make(const SourceContext& context) const {
  TableDeck plain;
  plain.name = *given;
  plain.file = {file.empty() ? given->value : file, given->location};
  const TableDeck* const named = find_table(context.named.tables, given->value);
  const TableDeck& deck = named == nullptr ? plain : *named;
  try {
    return Table::read(read_table(context.communicator, files, deck.file.value), deck,
                       context.wanted, context.diagnostics);
  } catch (const DeckError& error) {
    std::vector<std::string> names;
    for (const TableDeck& table : context.named.tables)
      names.push_back(table.name.value);
    context.diagnostics.error(
        deck.file.location,
        error.what() + (named != nullptr || names.empty()
                            ? ""
                            : ", and there is no <table> of that name; there are " + listed(names) +
                                  did_you_mean(given->value, names)));
  }
  return nullptr;
}

Spec<ConditionDeck> TrackSource::declare(Spec<ConditionDeck> spec) {
  return std::move(spec).attribute(attribute, &TrackSource::given, absent("no track"),
                                   "The displacement along this <track>; level in space.");
}

std::shared_ptr<const ValueSource> TrackSource::make(const SourceContext& context) const {
  auto track = find_track(context.named.tracks, *given, context.diagnostics);
  if (!track || context.wanted.count != 3) return track;
  return std::make_shared<LevelTrack>(std::move(track));
}

}  // namespace hawser
