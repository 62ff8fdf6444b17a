#pragma once
// A field at one point over time.
#include "hawser/report/report.hpp"

namespace hawser {

struct ProbeDeck {
  std::string name;
  Located<std::string> on, field;
  static Spec<ProbeDeck> spec();
};

class ProbeReport : public Report {
 public:
  using Parameters = ProbeDeck;
  ProbeReport(const ProbeDeck& deck, const ReportContext& context, Diagnostics& diagnostics);

  std::vector<Column> columns() const override { return columns_; }

 private:
  std::vector<double> measure(const Step& step) override;

  Communicator communicator_;
  std::vector<Column> columns_;
  LocalIndex first_row_ = -1;  // owned here, or -1
};

}  // namespace hawser
