#pragma once
// Where a condition's values come from: a struct per attribute, of which a condition has one. A
// further source is a struct like these and its name in the list of Sources.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/deck/read_deck.hpp"
#include "hawser/deck/spec.hpp"
#include "hawser/values/column.hpp"
#include "hawser/values/table_deck.hpp"
#include "hawser/values/tracks.hpp"

namespace hawser {

struct ConditionDeck;

/// What conditions ask for by name.
struct NamedSources {
  Tracks tracks{};
  std::vector<TableDeck> tables{};  ///< with files' paths beside the deck
};

struct SourceContext {
  const Communicator& communicator;
  const NamedSources& named;
  const WantedValues& wanted;
  Diagnostics& diagnostics;
};

/// What the attribute of one kind of source says.
template <class Kind, class Given>
struct SourceDeck {
  std::optional<Located<Given>> given;
  /// Paths become those beside the deck.
  void complete(const Deck& /*text*/) {}
};

/// Each kind has its attribute's name, its declaration, and make(), which is collective and returns
/// null, and reports, when there is no such source.
struct FormulaSource : SourceDeck<FormulaSource, Expressions> {
  static constexpr const char* attribute = "value";
  static Spec<ConditionDeck> declare(Spec<ConditionDeck> spec);
  std::shared_ptr<const ValueSource> make(const SourceContext& context) const;
};

struct TableSource : SourceDeck<TableSource, std::string> {
  static constexpr const char* attribute = "table";
  static Spec<ConditionDeck> declare(Spec<ConditionDeck> spec);
  void complete(const Deck& text);
  std::shared_ptr<const ValueSource> make(const SourceContext& context) const;
  std::string file;                        ///< where it is, should what is given be no <table>
  std::shared_ptr<InputFiles> files = {};  ///< of the deck
};

struct TrackSource : SourceDeck<TrackSource, std::string> {
  static constexpr const char* attribute = "track";
  static Spec<ConditionDeck> declare(Spec<ConditionDeck> spec);
  std::shared_ptr<const ValueSource> make(const SourceContext& context) const;
};

template <class... Kinds>
struct OneSourceOf : Kinds... {
  static Spec<ConditionDeck> declare_sources(Spec<ConditionDeck> spec) {
    ((spec = Kinds::declare(std::move(spec))), ...);
    return spec;
  }
  static std::vector<std::string> source_attributes() { return {Kinds::attribute...}; }
  int sources_given() const { return (int(Kinds::given.has_value()) + ...); }
  void complete_sources(const Deck& text) { (Kinds::complete(text), ...); }
  /// Null after a fault.
  std::shared_ptr<const ValueSource> make_source(const SourceContext& context) const {
    std::shared_ptr<const ValueSource> made;
    ((Kinds::given.has_value() ? void(made = Kinds::make(context)) : void()), ...);
    return made;
  }
  /// Of the attribute that was given.
  Location source_location() const {
    Location where;
    ((Kinds::given.has_value() ? void(where = Kinds::given->location) : void()), ...);
    return where;
  }
};

using Sources = OneSourceOf<FormulaSource, TableSource, TrackSource>;

}  // namespace hawser
