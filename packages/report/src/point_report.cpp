#include "src/point_report.hpp"

namespace hawser {

Spec<PointDeck> PointDeck::spec() {
  using P = PointDeck;
  return Spec<P>("point",
                 "Writes formulas of fields at a place over time, interpolated in the cell of the "
                 "moved body that is there. A <probe> follows a node instead.")
      .attribute("name", &P::name, required(), "Start of the quantities' names.")
      .attribute("at", &P::at, "m", required() && any() && length(2, 3),
                 "The place, fixed in space.")
      .attribute("of", &P::of, "SI", required() && any(),
                 "Formulas of place, time, fields and their derivatives, set apart by ';': each is "
                 "a quantity NAME_velocity_x, NAME_dx_temperature, else NAME or NAME_2.")
      .attribute("unit", &P::unit,
                 "Unit of what is no field and no derivative of one, for its name.")
      .check(check_name_and_unit<P>)
      .source("doc/decks.md");
}

PlacedFormulas::Place read_place(const Located<std::vector<double>>& given, const Mesh& mesh,
                                 const std::string& what, Diagnostics& diagnostics) {
  PlacedFormulas::Place place{};
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  if (given.value.size() != dimension)
    diagnostics.error(given.location, what + " has " + std::to_string(given.value.size()) +
                                          " coordinates, the mesh " + std::to_string(dimension));
  else
    std::copy(given.value.begin(), given.value.end(), place.begin());
  return place;
}

PointReport::PointReport(const PointDeck& deck, const ReportContext& context,
                         Diagnostics& diagnostics)
    : deck_(deck),
      formulas_(context, deck.of, deck.unit, "<point>", deck.at.location, diagnostics),
      place_(read_place(deck.at, context.mesh(), "the place of point '" + deck.name + "'",
                        diagnostics)) {}

std::vector<Column> PointReport::columns() const {
  std::vector<Column> columns = formulas_.columns();
  for (Column& column : columns)
    column.name = deck_.name + (column.name.empty() ? "" : "_") + column.name;
  return columns;
}

void PointReport::look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const {
  if (formulas_.inside({place_}, outlook.state)[0] == 0)
    diagnostics.error(deck_.at.location, "point '" + deck_.name + "' at " +
                                             place_text(place_.data(), deck_.at.value.size()) +
                                             " m is in no cell where its fields are solved for; " +
                                             formulas_.reach());
}

std::vector<double> PointReport::measure(const Step& step) {
  return formulas_.evaluate({place_}, formulas_.at(step)).values;
}

}  // namespace hawser
