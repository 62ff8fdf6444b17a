#pragma once
// Where a condition's values come from: formulas, a table, or a track. One call per node, never per
// quadrature point.
#include <limits>

#include "hawser/deck/expression.hpp"

namespace hawser {

/// Times, s, or places along an axis, m, at which there is a value.
struct Span {
  double from = -std::numeric_limits<double>::infinity();
  double until = std::numeric_limits<double>::infinity();
  double slack = 0;  ///< what lies outside by the rounding of sums of steps counts as inside
  bool covers(double first, double last) const {
    return from - slack <= first && last <= until + slack;
  }
};

class ValueSource {
 public:
  virtual ~ValueSource() = default;

  virtual int components() const = 0;
  /// [component]. Throws SolveError or DeckError where there is no value: call it within
  /// Communicator::together.
  virtual void value(const SpaceTime& at, double* values) const = 0;
  /// [component], per s, at a fixed place.
  virtual void time_derivative(const SpaceTime& at, double* rates) const = 0;
  /// [3], per m, of one component with respect to the moved position.
  virtual void gradient(const SpaceTime& at, int component, double* slope) const = 0;
  virtual bool depends_on_moved_position(int component) const = 0;

  virtual Span span() const { return {}; }
  /// Along x, y or z (0, 1, 2).
  virtual Span reach(int /*axis*/) const { return {}; }
  /// The values are displacements that bring every point to the same place.
  virtual bool places_a_point() const { return false; }

  bool depends_on_moved_position() const {
    for (int c = 0; c < components(); ++c)
      if (depends_on_moved_position(c)) return true;
    return false;
  }
};

}  // namespace hawser
