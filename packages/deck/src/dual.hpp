#pragma once
// Forward differentiation: a value with its derivatives, carried along by the chain rule.

namespace hawser {

/// By the moved position x, y, z and by the time t, in this order. Uninitialized by default, so
/// that a stack of them costs nothing.
struct Dual {
  static constexpr int directions = 4;
  double value;
  double slope[directions];

  Dual() = default;
  Dual(double number) : value(number), slope{0, 0, 0, 0} {}  // NOLINT: a number does not vary

  /// Becomes f(this), or f(this, other), of that value and those derivatives of f. Where one factor
  /// of a product is zero, so is the product, be the other infinite: sqrt(t)^3 stands at t = 0.
  void become(double f, double by_this) {
    value = f;
    for (double& s : slope)
      s = product(by_this, s);
  }
  void become(double f, double by_this, const Dual& other, double by_other) {
    value = f;
    for (int k = 0; k < directions; ++k)
      slope[k] = product(by_this, slope[k]) + product(by_other, other.slope[k]);
  }

  Dual& operator+=(const Dual& b) {
    value += b.value;
    for (int k = 0; k < directions; ++k)
      slope[k] += b.slope[k];
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    value -= b.value;
    for (int k = 0; k < directions; ++k)
      slope[k] -= b.slope[k];
    return *this;
  }
  Dual& operator*=(const Dual& b) {
    become(value * b.value, b.value, b, value);
    return *this;
  }
  Dual& operator/=(const Dual& b) {
    const double ratio = value / b.value;
    become(ratio, 1 / b.value, b, -ratio / b.value);
    return *this;
  }

 private:
  static double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }
};

inline void negate(double& u) { u = -u; }
inline void negate(Dual& u) { u.become(-u.value, -1); }
inline double value_of(double u) { return u; }
inline double value_of(const Dual& u) { return u.value; }

}  // namespace hawser
