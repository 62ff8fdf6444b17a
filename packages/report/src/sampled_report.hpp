#pragma once
// What reports of a formula over a region have in common.
#include "hawser/deck/field_expression.hpp"
#include "hawser/fields/region_sampling.hpp"
#include "hawser/physics/field_use.hpp"
#include "hawser/report/report.hpp"
#include "hawser/report/report_name.hpp"

namespace hawser {

/// The end of the step; but the instant of its equations where the formula names a field that has
/// no rate, such as a pressure, which is known there only.
class FormulaInstant {
 public:
  explicit FormulaInstant(const ReportContext& context) : rules_(context.rate_rules) {}
  void look_at(const FormulaFields& formula) {
    for (const int field : formula.fields())
      at_equations_ = at_equations_ || rules_[static_cast<std::size_t>(field)] == RateRule::none;
  }
  const State& operator()(const Step& step) const {
    return at_equations_ ? step.balance : step.end;
  }

 private:
  const std::vector<RateRule>& rules_;
  bool at_equations_ = false;
};

/// For Spec::check(): of a struct with `name` and `unit`.
template <class P>
void check_name_and_unit(const P& p, const Location& where, Diagnostics& diagnostics) {
  check_report_name(p, where, diagnostics);
  Unit unit;
  const std::string fault = p.unit.empty() ? "" : read_unit(p.unit, unit);
  if (!fault.empty()) diagnostics.error(where, "the unit '" + p.unit + "': " + fault);
}

inline int moving_field(const DofMap& dofs) { return dofs.find(field_name::displacement); }

}  // namespace hawser
