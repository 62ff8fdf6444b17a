#pragma once
// The integral, or the mean, of a formula over a region.
#include <optional>

#include "src/sampled_report.hpp"

namespace hawser {

struct IntegralDeck {
  std::string name, unit = "1";
  FieldExpression of;
  Located<std::string> on;
  bool mean = false;
  static Spec<IntegralDeck> spec();
};

class IntegralReport : public Report {
 public:
  using Parameters = IntegralDeck;
  IntegralReport(const IntegralDeck& deck, const ReportContext& context, Diagnostics& diagnostics);

  std::vector<Column> columns() const override { return {{deck_.name, deck_.unit}}; }

 private:
  /// SolveError on all ranks where the formula has no value.
  std::vector<double> measure(const Step& step) override;

  Communicator communicator_;
  IntegralDeck deck_;
  FormulaInstant instant_;
  std::optional<RegionSampling> sampling_;
};

}  // namespace hawser
