#pragma once
// A number, or a formula of place, time and fields, as decks give it: "1e-3*exp(-temperature/40)",
// "velocity_x*dx(temperature)". The language is that of Expression, and beside it
//
//   temperature      the value of a field of one component
//   velocity_x       a component of a field of several, _x, _y or _z
//   dx(temperature)  the derivative of a field, or of such a component, by the moved position x;
//   dy,
//                    dz alike
//
// A name that is none of variables, constants, functions and the deck's parameters is that of a
// field. Whether there is such a field is known only with the modules: whoever looks the references
// up tells what is not there.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/expression.hpp"

namespace hawser {

struct FieldReference {
  std::string field;
  int component = 0;
  int along = -1;          ///< -1: the value; 0, 1, 2: its derivative by x, y, z, per m
  bool of_vector = false;  ///< the formula names a component: velocity_x, not temperature

  std::string name() const;  ///< "velocity_x", "temperature"
  std::string text() const;  ///< as a formula has it, "dx(velocity_y)"
};

/// Compiled once; copies share the compiled formula, also in several threads. Derivatives are exact
/// (forward differentiation, see Expression). Evaluations allocate nothing and look nothing up.
///
/// A result that is not finite throws SolveError naming place, time and the fields' values; an
/// element loop catches it or is inside Communicator::together.
class FieldExpression {
 public:
  FieldExpression(double value = 0);  // NOLINT: a number is an expression
  /// Throws DeckError when the formula is faulty.
  explicit FieldExpression(const std::string& formula, const Location& location = {});
  /// The same without throwing: returns what is wrong, or "" and sets `result`. `names` may be
  /// null.
  static std::string compile(const std::string& formula, const Location& location,
                             const NamedValues* names, FieldExpression& result);
  static FieldExpression constant(double value, const std::optional<Unit>& unit,
                                  const Location& location);

  /// What it must be given, each once, in the order in which the formula names them.
  const std::vector<FieldReference>& references() const;

  /// `references`: a value for each of them, in their order.
  double operator()(const SpaceTime& point, const double* references = nullptr) const;
  /// The value; `slopes`[3 + references] receives its derivatives by the moved position x, y, z and
  /// by each reference.
  double tangent(const SpaceTime& point, const double* references, double* slopes) const;

  bool is_constant() const { return !compiled_; }
  bool depends_on_time() const;
  bool depends_on_space() const;           ///< itself, not by its fields: any of x, y, z, X, Y, Z
  bool depends_on_moved_position() const;  ///< any of x, y, z

  /// Of the polynomial that it is in a cell where places are of the degree `place` and each
  /// reference of that given; -1 where it is none, as with a root or a quotient.
  int degree(int place, const std::vector<int>& references) const;

  const std::string& text() const { return text_; }
  const Location& location() const { return location_; }
  /// The unit that a constant was given with, so that its dimension can be checked.
  const std::optional<Unit>& unit() const { return unit_; }

  /// Parameters of the deck that the formula uses: one that has a field's name hides that field.
  const std::vector<std::string>& parameters() const { return parameters_; }
  void uses_parameter(const std::string& name) { parameters_.push_back(name); }
  /// For the sentence about a reference to nothing: every name that a formula may have beside
  /// `fields` (variables, constants, parameters), and they.
  std::vector<std::string> names_beside(std::vector<std::string> fields) const;

 private:
  struct Compiled;
  double finite(double number, const std::string& what, const SpaceTime& point,
                const double* references) const;

  double value_ = 0;  // when constant
  std::shared_ptr<const Compiled> compiled_;
  std::string text_;
  std::vector<std::string> parameters_;  // of a constant, too
  std::optional<Unit> unit_;
  Location location_;
};

/// One per component, "0; 9.81*beta*(temperature - 293)".
using FieldExpressions = std::vector<FieldExpression>;

}  // namespace hawser
