#pragma once
// A property as a deck gives it: formulas of place, time and fields.
#include "hawser/deck/field_expression.hpp"
#include "hawser/physics/kernel_properties.hpp"
#include "hawser/physics/property.hpp"

namespace hawser {

class FormulaProperty : public PropertySource {
 public:
  /// One formula per component.
  FormulaProperty(const PropertyUse& property, int dimension, FieldExpressions formulas);
  /// Of a name from a deck, in the unit of whoever uses it.
  FormulaProperty(std::string name, int dimension, FieldExpressions formulas);

  int dimension() const override { return dimension_; }
  PropertyUse property() const override {
    return {name_.c_str(), unit_.c_str(), static_cast<int>(formulas_.size())};
  }
  std::unique_ptr<PropertySource> clone() const override {
    return std::make_unique<FormulaProperty>(*this);
  }
  void resolve(const std::vector<FieldUse>& run, Diagnostics& diagnostics) override;
  void check_unit(const char* wanted, Diagnostics& diagnostics) const override;
  void bind(const CellTabulation& table) override;
  bool evaluate(const CellInput& cell, double* values, double* slopes) const override;

 private:
  struct Reading {
    std::size_t field = 0;
    int component = 0;
    int along = -1;
  };
  template <int D>
  bool evaluate_in(const CellInput& cell, double* values, double* slopes) const;

  std::string name_, unit_;
  int dimension_;
  FieldExpressions formulas_;
  std::vector<std::vector<Reading>> readings_;  // [component][reference]
  int displacement_ = -1;                       // among fields(); -1: no formula asks for it
  CellTabulation table_;
  std::vector<int> first_;  // unknown of each field, and their number
};

/// What a module is given for one of its properties in its deck.
struct GivenProperty {
  PropertyUse property;
  FieldExpressions formulas;  ///< empty: not given
};

/// The constants of a kernel that uses these properties, in their order: none where nothing is
/// given; zeros where it is a formula, which becomes a supply on those cells and adds to them.
std::vector<PropertyConstant> give(const std::vector<GivenProperty>& all, const Domain& on,
                                   int dimension, std::vector<Supply>& supplies);

}  // namespace hawser
