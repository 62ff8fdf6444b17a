#pragma once
// A table read from a text at hand, as the conditions would have it read.
#include <memory>
#include <string>

#include "hawser/values/table.hpp"

namespace hawser {

inline WantedValues velocity(std::size_t first = 0, std::size_t count = 2) {
  return {"velocity", "m/s", {"x", "y"}, first, count, false};
}
inline WantedValues displacement() { return {"displacement", "m", {"x", "y"}, 0, 2, true}; }
inline WantedValues scalar(const std::string& field, const std::string& unit) {
  return {field, unit, {""}, 0, 1, false};
}

struct TableText {
  std::string text;
  WantedValues wanted = velocity();
  TableDeck deck{};
};

struct TableReading {
  std::shared_ptr<const Table> table;
  std::string faults;
};

inline TableReading read(TableText given) {
  Diagnostics diagnostics;
  given.deck.file.value = "t.csv";
  if (given.deck.name.value.empty()) given.deck.name = {"t", {"d.xml", 2, 3}};
  const auto table = Table::read(given.text, given.deck, given.wanted, diagnostics);
  return {table, diagnostics.error_text()};
}

inline SpaceTime at(double t, double x = 0, double y = 0, double z = 0) {
  SpaceTime point;
  point.t = t, point.x = x, point.y = y, point.z = z;
  return point;
}

/// The values there.
inline std::vector<double> values(const ValueSource& source, const SpaceTime& point) {
  std::vector<double> result(static_cast<std::size_t>(source.components()));
  source.value(point, result.data());
  return result;
}

/// What is said of `table` beside its file: direction="..." and so on.
template <class Edit>
TableDeck with(const Edit& edit) {
  TableDeck deck;
  edit(deck);
  return deck;
}

inline TableDeck with_direction(const std::string& sense) {
  return with([&](TableDeck& deck) { deck.direction = Located<std::string>{sense, {}}; });
}
inline TableDeck with_missing(std::vector<std::string> words, std::optional<double> gap = {}) {
  return with([&](TableDeck& deck) { deck.missing = std::move(words), deck.longest_gap = gap; });
}
inline TableDeck with_smoothing(double period) {
  return with([&](TableDeck& deck) { deck.smooth = Located<double>{period, {"d.xml", 2, 30}}; });
}
inline TableDeck with_origin(double easting, double northing) {
  return with([&](TableDeck& deck) {
    deck.origin = Located<std::vector<double>>{{easting, northing}, {"d.xml", 2, 40}};
  });
}

}  // namespace hawser
