#include "src/line_report.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "src/point_report.hpp"

namespace hawser {

Spec<LineDeck> LineDeck::spec() {
  using P = LineDeck;
  return Spec<P>(
             "line",
             "Writes formulas of fields at points along a straight line through the moved body: "
             "line_NAME.csv whenever fields are written, and over time each one's least and "
             "greatest "
             "value among the points and how far along the line they are.")
      .attribute("name", &P::name, required(), "Of the file, and start of the quantities' names.")
      .attribute("from", &P::from, "m", required() && any() && length(2, 3), "Its beginning.")
      .attribute("to", &P::to, "m", required() && any() && length(2, 3), "Its end.")
      .attribute("points", &P::points, at_least(2), "How many, with both ends, evenly apart.")
      .attribute("of", &P::of, "SI", required() && any(),
                 "Formulas of place, time, fields and their derivatives, set apart by ';'.")
      .attribute("unit", &P::unit,
                 "Unit of what is no field and no derivative of one, for its name.")
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        check_name_and_unit(p, where, diagnostics);
        if (p.from.value == p.to.value)
          diagnostics.error(where, "line '" + p.name + "' ends where it begins");
      })
      .source("doc/decks.md");
}

LineReport::LineReport(const LineDeck& deck, const ReportContext& context, Diagnostics& diagnostics)
    : mesh_(context.mesh()),
      deck_(deck),
      formulas_(context, deck.of, deck.unit, "<line>", deck.from.location, diagnostics) {
  const auto from =
      read_place(deck.from, mesh_, "the beginning of line '" + deck.name + "'", diagnostics);
  const auto to = read_place(deck.to, mesh_, "the end of line '" + deck.name + "'", diagnostics);
  length_ = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  for (int i = 0; i < deck.points; ++i) {
    PlacedFormulas::Place& place = places_.emplace_back();
    for (std::size_t j = 0; j < 3; ++j)
      place[j] = from[j] + i * (to[j] - from[j]) / (deck.points - 1);
  }
}

double LineReport::way(std::size_t point) const {
  return length_ * static_cast<double>(point) / static_cast<double>(places_.size() - 1);
}

std::vector<Column> LineReport::columns() const {
  std::vector<Column> columns;
  for (const Column& formula : formulas_.columns())
    for (const char* const which : {"_min", "_max"}) {
      const std::string name =
          deck_.name + (formula.name.empty() ? "" : "_") + formula.name + which;
      columns.push_back({name, formula.unit});
      columns.push_back({name + "_along", "m"});
    }
  return columns;
}

void LineReport::look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const {
  const std::vector<char> inside = formulas_.inside(places_, outlook.state);
  const auto outside = std::count(inside.begin(), inside.end(), 0);
  const std::string begin = "line '" + deck_.name + "': ";
  if (outside == static_cast<std::ptrdiff_t>(places_.size()))
    diagnostics.error(deck_.from.location,
                      begin + "none of its points is in a cell where its fields are solved for; " +
                          formulas_.reach());
  else if (outside > 0)
    diagnostics.note(deck_.from.location, begin + std::to_string(outside) + " of its " +
                                              std::to_string(places_.size()) +
                                              " points are in no cell where its fields are solved "
                                              "for at the start, and have no row then");
}

void LineReport::start(const ReportStart& start) {
  std::vector<Column> columns = {{"t", "s"}, {"along", "m"}};
  for (int j = 0; j < mesh_.dimension; ++j)
    columns.push_back({std::string(1, static_cast<char>('x' + j)), "m"});
  for (const Column& formula : formulas_.columns())
    columns.push_back(
        {formula.name.empty() || std::isdigit(static_cast<unsigned char>(formula.name[0])) != 0
             ? "value" + formula.name
             : formula.name,
         formula.unit});
  file_ =
      std::make_unique<History>(mesh_.communicator, start.folder + "/line_" + deck_.name + ".csv",
                                columns, start.keep_until());
}

std::vector<double> LineReport::measure(const Step& step) {
  last_ = formulas_.evaluate(places_, formulas_.at(step));
  const std::size_t count = formulas_.columns().size();
  std::vector<double> values;
  for (std::size_t f = 0; f < count; ++f)
    for (const double sign : {1.0, -1.0}) {
      double best = std::numeric_limits<double>::infinity(), along = 0;
      for (std::size_t i = 0; i < places_.size(); ++i) {
        if (last_.inside[i] == 0 || !(sign * last_.values[i * count + f] < best)) continue;
        best = sign * last_.values[i * count + f];
        along = way(i);
      }
      values.push_back(sign * best);
      values.push_back(along);
    }
  return values;
}

void LineReport::write(const Step& step, bool fields_due) {
  if (!fields_due) return;
  const std::size_t count = formulas_.columns().size();
  const auto dimension = static_cast<std::ptrdiff_t>(mesh_.dimension);
  std::vector<double> rows;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (last_.inside[i] == 0) continue;
    rows.insert(rows.end(), {step.end.time, way(i)});
    rows.insert(rows.end(), places_[i].begin(), places_[i].begin() + dimension);
    for (std::size_t f = 0; f < count; ++f)
      rows.push_back(last_.values[i * count + f]);
  }
  file_->append(rows);
}

}  // namespace hawser
