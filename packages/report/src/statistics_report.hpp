#pragma once
// What a column of history.csv comes to: its oscillation over the last periods.
#include "hawser/report/report.hpp"
#include "src/oscillation.hpp"

namespace hawser {

struct StatisticsDeck {
  std::string name;
  Located<std::string> of;
  double from = 0;  // s
  int periods = 10;
  static Spec<StatisticsDeck> spec();
};

class StatisticsReport : public Report {
 public:
  using Parameters = StatisticsDeck;
  StatisticsReport(const StatisticsDeck& deck, const ReportContext& /*context*/,
                   Diagnostics& /*diagnostics*/)
      : deck_(deck) {}

  void know(const std::vector<Column>& history, Diagnostics& diagnostics) override;
  void recorded(const std::vector<double>& row) override;
  std::vector<std::string> quantities() const override;
  void look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const override;
  void save(CheckpointNotes& notes) const override;
  void resume(const CheckpointNotes& notes) override;
  void summarise(const Step& last, Summary& summary) const override;
  std::string closing() const override;

 private:
  /// The quantities of `found` with their names.
  std::vector<std::pair<std::string, double>> named(const Oscillation& found) const;
  Oscillation oscillation() const { return find_oscillation(times_, values_, deck_.periods); }

  StatisticsDeck deck_;
  std::size_t column_ = 0;
  std::string unit_;
  std::vector<double> times_, values_;  // from `from` on; s, and the column's unit
};

}  // namespace hawser
