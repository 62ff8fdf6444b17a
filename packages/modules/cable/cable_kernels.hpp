#pragma once
// Line elements of a slender cable in the velocity's own basis (theory.md).
#include <array>
#include <cmath>

#include "hawser/physics/element_kernel.hpp"
#include "hawser/physics/tensor.hpp"

namespace hawser {

struct CableProperties {
  double mass = 60;               ///< per length, kg/m (per metre of depth)
  double axial_stiffness = 1e7;   ///< EA, N
  double bending_stiffness = 0;   ///< EI, N m^2
  double damping = 0;             ///< external, N s/m per length
  double slack_width = 1e-5;      ///< strain over which the tension is switched off smoothly
  double compressive_ratio = 0;   ///< stiffness left in compression, relative to EA
};

/// Second Piola tension of a cable that carries no compression, continuously differentiable in the strain:
/// zero below -width, EA E above +width, a parabola between.
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
    double length_squared = 0;
    for (int i = 0; i < D; ++i) {
      const double span = at.coordinate(1, i) - at.coordinate(0, i);
      length_squared += span * span;
    }
    const double length = std::sqrt(length_squared);
    Vector<T, D> stretch;  // x' = dx/dS
    // E from the displacement alone: 1 is never subtracted from |x'|^2, which would cost digits.
    T strain = 0.0;
    for (int i = 0; i < D; ++i) {
      const double direction = (at.coordinate(1, i) - at.coordinate(0, i)) / length;
      const T slope = (at.value(displacement, 1, i) - at.value(displacement, 0, i)) / length;
      stretch[i] = direction + slope;
      strain += slope * (direction + 0.5 * slope);
    }
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

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  CableProperties cable_;
};

/// Bending from the angle between neighbouring segments, rotation-free: energy EI |t2 - t1|^2 / (2 l) with
/// unit tangents t and l the mean segment length.
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
      for (int i = 0; i < D; ++i) tangent[s][i] *= inverse_length[s];
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
