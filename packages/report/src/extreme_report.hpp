#pragma once
// The least and the greatest value of a formula on a region, and where they are.
#include <optional>

#include "src/sampled_report.hpp"

namespace hawser {

struct ExtremeDeck {
  std::string name, unit;
  FieldExpression of;
  Located<std::string> on;
  static Spec<ExtremeDeck> spec();
};

class ExtremeReport : public Report {
 public:
  using Parameters = ExtremeDeck;
  ExtremeReport(const ExtremeDeck& deck, const ReportContext& context, Diagnostics& diagnostics);

  std::vector<Column> columns() const override;

 private:
  std::vector<double> measure(const Step& step) override;

  Communicator communicator_;
  int dimension_;
  ExtremeDeck deck_;
  FormulaInstant instant_;
  std::optional<RegionSampling> sampling_;
};

}  // namespace hawser
