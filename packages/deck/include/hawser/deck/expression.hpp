#pragma once
// A number, or a formula of place and time, as decks give it: "-0.5*ramp(t, 0, 100)".
//
// Variables: t (s); x, y, z (m) where the moving point is now; X, Y, Z (m) where it was at first.
// Constants: pi and the deck's parameters, in SI units. Operators, from weak to strong: a ? b : c,
// ||, &&, comparisons (1 or 0), + -, * /, the sign, ^ (from the right; -2^2 is -4). Functions: sin
// cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp ln log (natural too) log2 log10
// sqrt abs sign rint (halves go up) min max sum avg, and
//   ramp(t, start, duration)           0 before, 1 after, 10 s^3 - 15 s^4 + 6 s^5 between (C2)
//   ramp_distance(t, start, duration)  its integral over t, in s: the way of a ramped unit speed
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/location.hpp"
#include "hawser/deck/named_value.hpp"

namespace hawser {

struct SpaceTime {
  double x = 0, y = 0, z = 0;  ///< moved position, m
  double X = 0, Y = 0, Z = 0;  ///< reference position, m
  double t = 0;                ///< time, s
};

class Formula;

/// Compiled once; copies share the compiled formula, also in several threads. Derivatives are exact
/// (forward differentiation). At a kink they are those of one side: abs, sign and rint have slope 0
/// where they bend or jump, min and max the slope of the first of equal arguments, a ? b : c that
/// of the value taken.
///
/// A result that is not finite throws SolveError naming place and time. Evaluations inside an
/// element loop therefore belong into Communicator::together or an equivalent flag.
class Expression {
 public:
  Expression(double value = 0);  // NOLINT: a number is an expression
  /// Throws DeckError when the formula is faulty.
  explicit Expression(const std::string& formula, const Location& location = {});
  /// The same without throwing: returns what is wrong, or "" and sets `result`. `names` may be
  /// null.
  static std::string compile(const std::string& formula, const Location& location,
                             const NamedValues* names, Expression& result);
  /// A constant that was written with its unit, such as "2 kn"; `value` is in SI units.
  static Expression constant(double value, const std::optional<Unit>& unit,
                             const Location& location);

  double operator()(const SpaceTime& point) const;

  /// Per s, at a fixed place.
  double time_derivative(const SpaceTime& point) const;
  struct Tangent {
    double value = 0;
    std::array<double, 3> gradient{};  ///< per m, by the moved position x, y, z
  };
  Tangent tangent(const SpaceTime& point) const;

  bool is_constant() const { return !formula_; }
  bool depends_on_time() const;
  bool depends_on_space() const;           ///< any of x, y, z, X, Y, Z
  bool depends_on_moved_position() const;  ///< any of x, y, z

  const std::string& text() const { return text_; }
  const Location& location() const { return location_; }
  /// The unit that a constant was given with, so that its dimension can be checked.
  const std::optional<Unit>& unit() const { return unit_; }

 private:
  /// `number`, which is `what`, unless it is not finite.
  double finite(double number, const char* what, const SpaceTime& point) const;

  double value_ = 0;  // when constant
  std::shared_ptr<const Formula> formula_;
  std::string text_;
  std::optional<Unit> unit_;
  Location location_;
};

/// One per component, "0; -0.5*ramp(t, 0, 100)"; plain numbers may be set apart by blanks: "0
/// -0.5".
using Expressions = std::vector<Expression>;

}  // namespace hawser
