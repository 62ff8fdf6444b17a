#include "hawser/conditions/sources.hpp"

#include <fstream>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/conditions/conditions_deck.hpp"
#include "hawser/values/expression_source.hpp"
#include "hawser/values/table.hpp"

namespace hawser {
namespace {

std::string read_on_root(const Communicator& communicator, const std::string& path) {
  std::string text;
  communicator.on_root([&] {
    std::ifstream file(path);
    std::ostringstream all;
    all << file.rdbuf();
    if (!file) throw DeckError("cannot read the table " + path);
    text = all.str();
  });
  return communicator.broadcast(text);
}

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
      "CSV file of columns t, x, y and a column per component; linear between its rows. A "
      "relative path starts at the deck's folder.");
}

void TableSource::complete(const Deck& text) {
  if (given) given->value = path_beside(text, *given);
}

std::shared_ptr<const ValueSource> TableSource::make(const SourceContext& context) const {
  try {
    return std::make_shared<Table>(read_on_root(context.communicator, given->value), given->value);
  } catch (const DeckError& error) {
    context.diagnostics.error(given->location, error.what());
  }
  return nullptr;
}

Spec<ConditionDeck> TrackSource::declare(Spec<ConditionDeck> spec) {
  return std::move(spec).attribute(attribute, &TrackSource::given, absent("no track"),
                                   "The displacement along this <track>.");
}

std::shared_ptr<const ValueSource> TrackSource::make(const SourceContext& context) const {
  return find_track(context.tracks, *given, context.diagnostics);
}

}  // namespace hawser
