#pragma once
// Line elements of a slender cable in the velocity's own basis (theory.md).
#include <array>
#include <cmath>

#include "hawser/physics/element_kernel.hpp"
#include "hawser/physics/tensor.hpp"

namespace hawser {

struct CableProperties {
  double mass = 60;              ///< per length, kg/m (per metre of depth)
  double axial_stiffness = 1e7;  ///< EA, N
  double bending_stiffness = 0;  ///< EI, N m^2
  double damping = 0;            ///< external, N s/m per length
  double slack_width = 1e-5;     ///< strain over which the tension is switched off smoothly
  double compressive_ratio = 0;  ///< stiffness left in compression, relative to EA
};

/// Second Piola tension of a cable that carries no compression, continuously differentiable in the
/// strain: zero below -width, EA E above +width, a parabola between.
template <class T>
T slack_tension(const T& strain, const CableProperties& cable) {
  const double width = cable.slack_width;
  T tension = cable.compressive_ratio * strain;
  const double carried = 1 - cable.compressive_ratio;
  if (strain > width)
    tension += carried * strain;
  else if (strain > -width)
    tension += carried * (strain + width) * (strain + width) / (4 * width);
  return cable.axial_stiffness * tension;
}

/// Inertia, external damping and membrane force: Green-Lagrange strain E = (|x'|^2 - 1)/2.
class CableKernel : public ElementKernel<CableKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr int nodes = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<2>::velocity.as(Role::adds, need::value | need::rate),
      StandardFields<2>::displacement.as(Role::kinematic, need::value)};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  CableKernel(std::string region, const CableProperties& cable)
      : ElementKernel(std::move(region)), cable_(cable) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    constexpr int D = dimension;
    const auto [length, strain, stretch] =
        deform<T>([&](int a, int i) { return at.coordinate(a, i); },
                  [&](int a, int i) { return at.value(displacement, a, i); });
    const T tension = slack_tension(strain, cable_);
    for (int i = 0; i < D; ++i) {
      const T force = tension * stretch[i];
      out[at.index(velocity, 0, i)] -= force;
      out[at.index(velocity, 1, i)] += force;
      T load[2];
      for (int a = 0; a < 2; ++a)
        load[a] = cable_.mass * at.rate(velocity, a, i) + cable_.damping * at.value(velocity, a, i);
      out[at.index(velocity, 0, i)] += length / 6 * (2.0 * load[0] + load[1]);
      out[at.index(velocity, 1, i)] += length / 6 * (load[0] + 2.0 * load[1]);
    }
  }

  std::vector<Quantity> quantities() const override { return {{"tension", "N/m"}}; }
  /// The true tension, stretch times second Piola tension.
  void evaluate(const CellInput& cell, double* values) const override {
    const auto [length, strain, stretch] = deform<double>(
        [&](int a, int i) { return cell.coordinates[a * dimension + i]; },
        [&](int a, int i) { return cell.fields[displacement].value[a * dimension + i]; });
    values[0] = std::sqrt(1 + 2 * strain) * slack_tension(strain, cable_);
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  template <class T>
  struct Deformation {
    double length;         ///< reference length, m
    T strain;              ///< Green-Lagrange
    Vector<T, 2> stretch;  ///< x' = dx/dS
  };

  template <class T, class Reference, class Displacement>
  static Deformation<T> deform(Reference&& X, Displacement&& d) {
    double squared = 0;
    for (int i = 0; i < dimension; ++i)
      squared += (X(1, i) - X(0, i)) * (X(1, i) - X(0, i));
    Deformation<T> result{std::sqrt(squared), T(0.0), {}};
    // E from the displacement alone: 1 is never subtracted from |x'|^2, which would cost digits.
    for (int i = 0; i < dimension; ++i) {
      const double direction = (X(1, i) - X(0, i)) / result.length;
      const T slope = (d(1, i) - d(0, i)) / result.length;
      result.stretch[i] = direction + slope;
      result.strain += slope * (direction + 0.5 * slope);
    }
    return result;
  }

  CableProperties cable_;
};

/// Bending from the angle between neighbouring segments, rotation-free: energy EI |t2 - t1|^2 / (2
/// l) with unit tangents t and l the mean segment length.
class BendingKernel : public ElementKernel<BendingKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr int nodes = 3;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<2>::velocity.as(Role::adds, 0U),
      StandardFields<2>::displacement.as(Role::kinematic, need::value)};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  BendingKernel(std::string patches, const CableProperties& cable)
      : ElementKernel(std::move(patches)), cable_(cable) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    constexpr int D = dimension;
    Vector<T, D> tangent[2];
    T inverse_length[2];
    double mean_length = 0;
    for (int s = 0; s < 2; ++s) {
      double reference = 0;
      T squared = 0.0;
      for (int i = 0; i < D; ++i) {
        const double span = at.coordinate(s + 1, i) - at.coordinate(s, i);
        reference += span * span;
        tangent[s][i] = span + at.value(displacement, s + 1, i) - at.value(displacement, s, i);
        squared += tangent[s][i] * tangent[s][i];
      }
      mean_length += 0.5 * std::sqrt(reference);
      using std::sqrt;
      inverse_length[s] = 1.0 / sqrt(squared);
      for (int i = 0; i < D; ++i)
        tangent[s][i] *= inverse_length[s];
    }
    const T cosine = dot(tangent[0], tangent[1]);
    const double stiffness = cable_.bending_stiffness / mean_length;
    for (int i = 0; i < D; ++i) {
      // d(energy)/d(segment end): the part of the other tangent normal to this one.
      const T pull[2] = {-stiffness * inverse_length[0] * (tangent[1][i] - cosine * tangent[0][i]),
                         -stiffness * inverse_length[1] * (tangent[0][i] - cosine * tangent[1][i])};
      for (int s = 0; s < 2; ++s) {
        out[at.index(velocity, s, i)] -= pull[s];
        out[at.index(velocity, s + 1, i)] += pull[s];
      }
    }
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  CableProperties cable_;
};

}  // namespace hawser
