#pragma once
// What a formula names, looked up among the fields of a run once, and evaluated at points of cells.
#include <string>
#include <vector>

#include "hawser/deck/look_up_field.hpp"
#include "hawser/fields/field_sampler.hpp"

namespace hawser {

class FormulaFields {
 public:
  /// Names that are no fields are errors with the nearest one. Where `on_boundary`, normal_x,
  /// normal_y and normal_z are known, too.
  FormulaFields(const DofMap& dofs, FieldExpression formula, bool on_boundary,
                Diagnostics& diagnostics);

  bool complete() const { return complete_; }  ///< all names were found
  const FieldExpression& formula() const { return formula_; }
  const std::vector<int>& fields() const { return fields_; }  ///< indices in the DofMap, once each
  bool has_derivatives() const;
  bool has_normal() const;

  /// For a rule that integrates it exactly on straight cells. Of a formula that is no polynomial, a
  /// degree whose error is far below that of the fields.
  int quadrature_degree(const DofMap& dofs, int moving) const;

  /// Where the sampler, made for fields(), stands. SolveError where the formula has no value.
  double value(const FieldSampler& at, const Vector<double, 3>& normal = {}) const;

  /// "velocity_x", "dx_temperature" where the formula is nothing but that, and its unit; else "".
  std::string plain_name() const;
  std::string plain_unit(const DofMap& dofs) const;

 private:
  struct Item {
    std::size_t field;  // in fields_
    int component, along;
    bool is_normal;
  };
  Item look_up(const FormulaNames& names, const FieldReference& reference, bool on_boundary,
               Diagnostics& diagnostics);
  bool is_plain() const;

  FieldExpression formula_;
  bool complete_ = true;
  std::vector<int> fields_;
  std::vector<Item> items_;  // per reference of the formula
};

}  // namespace hawser
