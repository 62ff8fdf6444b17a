#pragma once
// Formulas of fields at fixed places, in whichever cell of the moved body is there.
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "hawser/fields/cell_locator.hpp"
#include "src/sampled_report.hpp"

namespace hawser {

class PlacedFormulas {
 public:
  /// `unit`: of what is not simply a field or a derivative of one. `user`: for the sentence where
  /// there is no body.
  PlacedFormulas(const ReportContext& context, const std::vector<FieldExpression>& formulas,
                 const std::string& unit, const std::string& user, const Location& where,
                 Diagnostics& diagnostics);

  /// A name and a unit for each formula: "velocity_x", "dx_temperature"; else "", or a number where
  /// there are several.
  const std::vector<Column>& columns() const { return columns_; }
  const State& at(const Step& step) const { return instant_(step); }

  using Place = std::array<double, 3>;  // m
  struct Values {
    std::vector<char> inside;    ///< per place: it is in a cell where all the fields are solved for
    std::vector<double> values;  ///< [place][formula]; not numbers outside
  };
  /// The same on all ranks. On an edge of cells that of the least number counts. Collective;
  /// SolveError where a formula has no value.
  Values evaluate(const std::vector<Place>& places, const State& state) const;
  /// Of the places alone: at the start a formula may have no value yet. Collective.
  std::vector<char> inside(const std::vector<Place>& places, const State& state) const;

  /// "the body reaches from (0, 0) to (4, 2) m". Collective; after evaluate() or inside().
  std::string reach() const;

 private:
  template <class Evaluate>
  Values each(const std::vector<Place>& places, const State& state, Evaluate&& evaluate) const;

  const DofMap& dofs_;
  FormulaInstant instant_;
  std::vector<FormulaFields> formulas_;
  std::vector<Column> columns_;
  std::unique_ptr<CellLocator> locator_;  // none where there is no body
};

/// "(1, 2)".
std::string place_text(const double* place, std::size_t dimension);

}  // namespace hawser
