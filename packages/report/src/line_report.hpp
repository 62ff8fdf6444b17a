#pragma once
// Formulas of fields along a straight line through the body, as a table.
#include <memory>

#include "src/placed_formulas.hpp"

namespace hawser {

struct LineDeck {
  std::string name, unit = "1";
  Located<std::vector<double>> from, to;
  int points = 101;
  FieldExpressions of;
  static Spec<LineDeck> spec();
};

class LineReport : public Report {
 public:
  using Parameters = LineDeck;
  LineReport(const LineDeck& deck, const ReportContext& context, Diagnostics& diagnostics);

  std::vector<Column> columns() const override;
  /// An error where it misses the body at the start, a note where a part of it does.
  void look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const override;
  void start(const ReportStart& start) override;
  void write(const Step& step, bool fields_due) override;

 private:
  std::vector<double> measure(const Step& step) override;
  double way(std::size_t point) const;  // m, along the line

  const Mesh& mesh_;
  LineDeck deck_;
  PlacedFormulas formulas_;
  std::vector<PlacedFormulas::Place> places_;
  double length_ = 0;
  PlacedFormulas::Values last_;
  std::unique_ptr<History> file_;
};

}  // namespace hawser
