#pragma once
// Forces on regions: the load of one module, or the reaction of the supports.
#include "hawser/report/force.hpp"
#include "src/row_sums.hpp"

namespace hawser {

struct ForceDeck {
  std::string name;
  Located<std::string> on;
  Located<std::string> module{"all", {}};
  Located<std::vector<std::string>> module_on;  ///< all when empty
  Located<std::vector<double>> axis;            ///< +x when empty
  static Spec<ForceDeck> spec();
};

class ForceReport : public Report {
 public:
  using Parameters = ForceDeck;
  ForceReport(const ForceDeck& deck, const ReportContext& context, Diagnostics& diagnostics);

  std::vector<Column> columns() const override;
  std::string closing() const override;

 private:
  /// Load on the region of the modules of that name, or the reaction.
  std::vector<double> measure(const Step& step) override;

  const Mesh& mesh_;
  ForceDeck deck_;
  RowSums loads_;
};

}  // namespace hawser
