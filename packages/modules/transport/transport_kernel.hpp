#pragma once
// Heat or a scalar, carried by the flow and conducted, at a quadrature point (theory.md).
#include <array>

#include "hawser/physics/cell_metric.hpp"
#include "hawser/physics/moving_point_kernel.hpp"

namespace hawser {

/// What is carried: the temperature, or a scalar that the deck names.
struct HeatQuantity {
  template <int D>
  static constexpr FieldUse field = StandardFields<D>::temperature;
  static constexpr PropertyUse capacity{"heat capacity", "J/(m^3 K)"};
  static constexpr PropertyUse conductivity{"conductivity", "W/(m K)"};
  static constexpr PropertyUse source{"heat source", "W/m^3", 1, 0.0};
  static constexpr PropertyUse decay{"heat decay", "1/s", 1, 0.0};
};
struct ScalarQuantity {
  template <int D>
  static constexpr FieldUse field{"scalar", "1", D == 2 ? "m^2/s" : "m^3/s", 1, RateRule::dynamic};
  static constexpr PropertyUse capacity{"scalar capacity", "1", 1, 1.0};
  static constexpr PropertyUse conductivity{"scalar diffusivity", "m^2/s"};
  static constexpr PropertyUse source{"scalar source", "1/s", 1, 0.0};
  static constexpr PropertyUse decay{"scalar decay", "1/s", 1, 0.0};
};

/// "tracer diffusivity": each field has its own.
inline std::string scalar_property(const std::string& field, const PropertyUse& use) {
  return field + std::string(use.name).substr(std::string("scalar").size());
}

/// Linear shapes with residual-based streamline stabilisation, whose subscale has a rate of its
/// own: a steady state knows no step.
template <int D, class Quantity>
class TransportKernel : public MovingPointKernel<TransportKernel<D, Quantity>> {
 public:
  static constexpr int dimension = D;
  static constexpr int memory = 1;  // the subscale
  static constexpr std::array<FieldUse, 3> uses = {
      Quantity::template field<D>.only(Basis::p1).as(Role::adds,
                                                     need::value | need::rate | need::gradient),
      StandardFields<D>::velocity.as(Role::reads_if_solved, need::value),
      StandardFields<D>::displacement.as(Role::reads_if_solved, need::rate | need::gradient)};
  static constexpr std::array<PropertyUse, 5> properties = {
      Quantity::capacity, Quantity::conductivity, Quantity::source, Quantity::decay,
      property::eddy_viscosity};
  static constexpr Slot<0> carried{};
  static constexpr Slot<1> velocity{};
  static constexpr Slot<2> displacement{};
  static constexpr PropertySlot<0> capacity{};
  static constexpr PropertySlot<1> conductivity{};
  static constexpr PropertySlot<2> source{};
  static constexpr PropertySlot<3> decay{};
  static constexpr PropertySlot<4> eddy_viscosity{};

  /// `turbulent_number`: of Prandtl or Schmidt, eddy viscosity over eddy diffusivity.
  TransportKernel(Domain domain, std::vector<PropertyConstant> constants, double turbulent_number)
      : MovingPointKernel<TransportKernel>(std::move(domain), std::move(constants)),
        turbulent_number_(turbulent_number) {}

  void name_scalar(const std::string& name, const std::string& unit) {
    this->name_field(0, name, unit,
                     unit == "1" ? uses[0].residual_unit : unit + " " + uses[0].residual_unit);
    for (std::size_t p = 0; p < 4; ++p)
      this->own_properties().rename(p, scalar_property(name, properties[p]));
  }

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    using T = typename Point::Number;
    const Balance<T> balance = balance_at<T>(at);
    const auto& gradient = at[carried].gradient;
    out[carried].source = balance.strong_residual +
                          at[capacity] * (balance.subscale_rate + at[decay] * balance.subscale);
    for (int i = 0; i < D; ++i)
      out[carried].flux[i] = balance.conductivity * gradient[i] -
                             at[capacity] * balance.subscale * balance.convection[i];
  }

  template <class Point>
  void moved_advance(const Point& at, double* next) const {
    next[0] = balance_at<double>(at).subscale;
  }

  std::vector<double> sample_amplitudes() const override { return {10, 1, 0.05}; }

 private:
  template <class T>
  struct Balance {
    Vector<T, D> convection;  ///< relative to the mesh, m/s
    T conductivity;           ///< molecular and turbulent
    T strong_residual;        ///< per volume; its conduction vanishes for linear shapes
    T subscale, subscale_rate;
  };

  /// C dT'/dt + C (1/tau + s) T' = -R, by implicit Euler from the instant of the last equations.
  template <class T, class Point>
  Balance<T> balance_at(const Point& at) const {
    Balance<T> balance;
    for (int i = 0; i < D; ++i)
      balance.convection[i] = at[velocity].value[i] - at[displacement].rate[i];
    balance.conductivity = at[conductivity] + at[capacity] * at[eddy_viscosity] / turbulent_number_;
    balance.strong_residual =
        at[capacity] * (at[carried].rate + dot(balance.convection, at[carried].gradient) +
                        at[decay] * at[carried].value) -
        at[source];
    const T diffusivity = balance.conductivity / at[capacity];
    const T rate = subscale_rate(cell_metric(at), balance.convection, diffusivity) + at[decay];
    const double per_step = 1 / at.elapsed;  // 0 in a steady solve
    balance.subscale =
        (per_step * at.memory[0] - balance.strong_residual / at[capacity]) / (per_step + rate);
    balance.subscale_rate = per_step * (balance.subscale - at.memory[0]);
    return balance;
  }

  double turbulent_number_;
};

}  // namespace hawser
