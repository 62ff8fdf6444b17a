#pragma once
// The law of a cable that carries no compression (theory.md, "Slack" and "Over a step").
#include <algorithm>
#include <cmath>

namespace hawser {

struct CableProperties {
  double mass = 60;              ///< per length, kg/m (in a flow in the plane: per metre of depth)
  double axial_stiffness = 1e7;  ///< EA, N
  double bending_stiffness = 0;  ///< EI, N m^2
  double damping = 0;            ///< external, N s/m per length
  double axial_damping = 0;      ///< internal, of the strain rate, N s
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

/// The energy per length whose derivative that tension is, N.
inline double strain_energy(double strain, const CableProperties& cable) {
  const double width = cable.slack_width;
  double energy = 0.5 * cable.compressive_ratio * strain * strain;
  const double carried = 1 - cable.compressive_ratio;
  const double above = strain + width;
  if (strain > width)
    energy += carried * (0.5 * strain * strain + width * width / 6);
  else if (strain > -width)
    energy += carried * above * above * above / (12 * width);
  return cable.axial_stiffness * energy;
}

/// Mean of the tension over the strains between two, the difference of their energies over that of
/// the strains; written so that no digits are lost where the two are close.
template <class T>
T mean_tension(double before, const T& after, const CableProperties& cable) {
  const double width = cable.slack_width;
  const double carried = 1 - cable.compressive_ratio;
  T tension = 0.5 * cable.compressive_ratio * (before + after);
  const auto parabola = [&](const T& a, const T& b) {
    const T from = a + width, to = b + width;
    return T((from * from + from * to + to * to) / (12 * width));
  };
  if (before >= width && after >= width)
    tension += 0.5 * carried * (before + after);
  else if (std::abs(before) <= width && after >= -width && after <= width)
    tension += carried * parabola(before, after);
  else if (before > -width || after > -width) {
    // The part of the way on each branch; they differ, or one of the cases above would hold.
    const T way = after - before;
    const T inside_from = std::clamp(before, -width, width);
    const T inside_to = after > width ? T(width) : after < -width ? T(-width) : after;
    tension += carried * parabola(inside_from, inside_to) * ((inside_to - inside_from) / way);
    const double taut_from = std::max(before, width);
    const T taut_to = after > width ? after : T(width);
    tension += 0.5 * carried * (taut_from + taut_to) * ((taut_to - taut_from) / way);
  }
  return cable.axial_stiffness * tension;
}

/// At the instant after `share` of a step, from one half to all of it, in which the strain goes
/// from `before` to `after`. The mean over the step does just the work that the energy gains; the
/// tension at the end does more, because the energy is convex. Second order for every share.
template <class T>
T tension_in_step(double before, const T& after, double share, const CableProperties& cable) {
  if (share == 1) return slack_tension(after, cable);
  return 2 * (1 - share) * mean_tension(before, after, cable) +
         (2 * share - 1) * slack_tension(after, cable);
}

/// The same with the branch of a taut cable for all strains.
template <class T>
T taut_tension_in_step(double before, const T& after, double share, const CableProperties& cable) {
  return cable.axial_stiffness * (before + share * (after - before));
}

}  // namespace hawser
