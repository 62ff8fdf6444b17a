#pragma once
// What a formula's reference means among the fields of a run.
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/field_expression.hpp"

namespace hawser {

struct NamedField {
  std::string name;
  int components = 1;
};

/// What formulas may name in a run.
struct FormulaNames {
  std::vector<NamedField> fields;
  int dimension = 2;
  std::vector<std::string> others{};  ///< that the user of the formula knows itself: "normal_x"
};

struct FoundField {
  std::size_t field = 0;  ///< in FormulaNames::fields
  int component = 0;
  int along = -1;  ///< -1: the value
};

/// Nothing after a fault, which is told at the formula's place, with the nearest name.
std::optional<FoundField> look_up_field(const FieldExpression& formula,
                                        const FieldReference& reference, const FormulaNames& names,
                                        Diagnostics& diagnostics);

/// A parameter of the deck that the formula uses may not hide a field of the same name.
void refuse_hidden_fields(const FieldExpression& formula, const std::vector<NamedField>& fields,
                          Diagnostics& diagnostics);

/// "'dx(u)' in the formula '2*dx(u)' is ", for a sentence about that reference.
std::string begin_of_fault(const FieldExpression& formula, const FieldReference& reference);

}  // namespace hawser
