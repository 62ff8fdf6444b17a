#pragma once
// What flows into a field's balance at the nodes of a region.
#include "src/row_sums.hpp"

namespace hawser {

struct FluxDeck {
  std::string name;
  Located<std::string> field;
  Located<std::vector<std::string>> on;
  Located<std::string> module{"all", {}};
  Located<std::vector<std::string>> module_on;
  static Spec<FluxDeck> spec();
};

class FluxReport : public Report {
 public:
  using Parameters = FluxDeck;
  FluxReport(const FluxDeck& deck, const ReportContext& context, Diagnostics& diagnostics);

  std::vector<Column> columns() const override { return columns_; }
  /// A note where nothing holds the field on the region: then its reaction is nothing.
  void look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const override;

 private:
  std::vector<double> measure(const Step& step) override { return loads_.sum(step); }

  const DofMap& dofs_;
  FluxDeck deck_;
  RowSums loads_;
  std::vector<Column> columns_;
};

}  // namespace hawser
