#include "src/statistics_report.hpp"

#include <fmt/format.h>

#include <sstream>

#include "hawser/report/report_name.hpp"

namespace hawser {

Spec<StatisticsDeck> StatisticsDeck::spec() {
  using P = StatisticsDeck;
  return Spec<P>("statistics",
                 "Reports of a column of history.csv that oscillates: NAME_average over time; "
                 "NAME_middle and NAME_amplitude, half the sum and the difference of a period's "
                 "extremes; NAME_frequency; NAME_periods, over how many; and by how much a single "
                 "period departs from that, NAME_amplitude_scatter and NAME_frequency_scatter, "
                 "relative. A period goes from one rise through the middle to the next; ripples of "
                 "less than half the amplitude make none.")
      .attribute("name", &P::name, required(), "Start of the quantities' names.")
      .attribute("of", &P::of, required(), "Column of history.csv, such as tip_displacement_y_m.")
      .attribute("from", &P::from, "s", at_least(0), "What came before is not looked at.")
      .attribute("periods", &P::periods, "1", at_least(1), "The last so many are looked at.")
      .check(check_report_name<P>)
      .source("doc/decks.md");
}

void StatisticsReport::know(const std::vector<Column>& history, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const Column& column : history) {
    names.push_back(quantity_name(column));
    if (names.back() != deck_.of.value) continue;
    column_ = names.size() - 1;
    unit_ = column.unit;
    return;
  }
  diagnostics.error(deck_.of.location, "no report here gives a column " +
                                           hawser::quoted(deck_.of.value) +
                                           " of history.csv; there are " + listed(names) +
                                           did_you_mean(deck_.of.value, names));
}

void StatisticsReport::look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const {
  if (deck_.from >= outlook.span.end)
    diagnostics.error(deck_.of.location,
                      fmt::format("statistics '{}' begin at {:g} s, but the run ends at {:g} s",
                                  deck_.name, deck_.from, outlook.span.end));
}

void StatisticsReport::recorded(const std::vector<double>& row) {
  const double time = row.front();
  if (time < deck_.from) return;
  times_.push_back(time);
  values_.push_back(row[column_]);
}

std::vector<std::pair<std::string, double>> StatisticsReport::named(
    const Oscillation& found) const {
  const auto name = [&](const char* what, const std::string& unit) {
    return quantity_name({deck_.name + what, unit});
  };
  return {{name("_average", unit_), found.average},
          {name("_middle", unit_), found.middle},
          {name("_amplitude", unit_), found.amplitude},
          {name("_frequency", "Hz"), found.frequency},
          {name("_periods", ""), found.periods},
          {name("_amplitude_scatter", ""), found.amplitude_scatter},
          {name("_frequency_scatter", ""), found.frequency_scatter}};
}

std::vector<std::string> StatisticsReport::quantities() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : named({}))
    names.push_back(name);
  return names;
}

void StatisticsReport::summarise(const Step& /*last*/, Summary& summary) const {
  const Oscillation found = oscillation();
  if (found.periods == 0)  // nothing that an <expect> could take for a number
    summary.set(quantity_name({deck_.name + "_periods", ""}), 0);
  else
    for (const auto& [name, value] : named(found))
      summary.set(name, value);
}

std::string StatisticsReport::closing() const {
  const Oscillation found = oscillation();
  if (found.periods == 0)
    return fmt::format("{}: no whole period of {} from {:g} s on\n", deck_.name, deck_.of.value,
                       deck_.from);
  return fmt::format(
      "{}: {:.5g} +- {:.5g} {}, {:.5g} Hz, over {} period{} from {:.6g} to {:.6g} s; amplitudes "
      "within {:.2g} %\n",
      deck_.name, found.middle, found.amplitude, unit_, found.frequency, found.periods,
      found.periods == 1 ? "" : "s", found.from, found.to, 100 * found.amplitude_scatter);
}

void StatisticsReport::save(CheckpointNotes& notes) const {
  std::string series;
  for (std::size_t i = 0; i < times_.size(); ++i)
    series += fmt::format("{} {}\n", times_[i], values_[i]);  // fmt's digits give the same double
  notes.texts["series"] = series;
}

void StatisticsReport::resume(const CheckpointNotes& notes) {
  std::istringstream series(notes.texts.at("series"));
  std::string time, value;
  while (series >> time >> value) {
    times_.push_back(std::stod(time));
    values_.push_back(std::stod(value));
  }
}

}  // namespace hawser
