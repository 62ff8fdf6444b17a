#pragma once
// The energy balance over time, by the names that the modules give its terms.
#include "hawser/deck/spec.hpp"
#include "hawser/report/report.hpp"

namespace hawser {

/// <energy-balance>: there is nothing to choose.
struct EnergyBalance {
  static Spec<EnergyBalance> spec();
};

class EnergyReport : public Report {
 public:
  using Parameters = EnergyBalance;
  EnergyReport(const EnergyBalance& deck, const ReportContext& context, Diagnostics& diagnostics);

  std::vector<Column> columns() const override;
  std::string closing() const override;
  bool looks_at_energy() const override { return true; }

 private:
  std::vector<double> measure(const Step& step) override;

  const Assembler& assembler_;
};

}  // namespace hawser
