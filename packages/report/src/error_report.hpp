#pragma once
// Norms of the difference between a field and its exact solution.
#include "hawser/report/report.hpp"

namespace hawser {

/// The difference between a field and its exact solution, measured at the end of the run.
struct ErrorDeck {
  std::string name;
  Located<std::string> field, on;
  Located<Expressions> exact;
  bool up_to_constant = false;
  static Spec<ErrorDeck> spec();
};

class ErrorReport : public Report {
 public:
  using Parameters = ErrorDeck;
  ErrorReport(const ErrorDeck& deck, const ReportContext& context, Diagnostics& diagnostics);

  /// SolveError where the exact solution has no value.
  std::vector<std::string> quantities() const override {
    return {deck_.name + "_error_l2", deck_.name + "_error_max"};
  }
  void summarise(const Step& last, Summary& summary) const override;

 private:
  struct Sample {
    double weight;  ///< m^2 or m
    double error[3];
  };
  std::vector<Sample> sample(const State& state) const;
  void leave_out_mean(std::vector<Sample>& samples) const;

  const DofMap& dofs_;
  ErrorDeck deck_;
  const Region* region_ = nullptr;
  int field_ = -1;  // index in the DofMap
  std::size_t components_ = 0;
  bool has_rate_ = false;  // it lives at the end of the step, others at the equations' instant
};

}  // namespace hawser
