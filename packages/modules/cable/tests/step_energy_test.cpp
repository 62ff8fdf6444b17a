// Over a step the forces do at least the work that their energy gains, and in the middle of it just
// that (theory.md, "Over a step").
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "axial_kernel.hpp"
#include "bending_kernel.hpp"

namespace hawser {
namespace {

/// A cell of a cable kernel, at the start of a step and at its end, both at random.
class SampleStep {
 public:
  /// `nodes` on a line along x, 0.7 m apart; moved by up to `amplitude`, m.
  SampleStep(const Kernel& kernel, int dimension, double amplitude, unsigned seed)
      : kernel_(kernel), dimension_(dimension) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-amplitude, amplitude);
    const int nodes = kernel.nodes(0);
    for (int a = 0; a < nodes; ++a)
      for (int i = 0; i < dimension; ++i) {
        X_.push_back(i == 0 ? 0.7 * a : 0);
        before_.push_back(any(random));
        after_.push_back(any(random));
      }
  }

  /// Of the forces that the kernel forms after a share of the step, along the whole step, J.
  double work(double share) const {
    const std::size_t n = before_.size();
    std::vector<double> now(n), zero(n, 0), residual(2 * n);
    for (std::size_t i = 0; i < n; ++i)
      now[i] = before_[i] + share * (after_[i] - before_[i]);
    const FieldOnCell fields[] = {
        {zero.data(), zero.data(), zero.data(), zero.data(), zero.data()},
        {now.data(), zero.data(), before_.data(), zero.data(), zero.data()}};
    const CellInput cell{0, 0.1, X_.data(), fields, nullptr, 0.1, share, true, false};
    EXPECT_EQ(kernel_.residual(cell, residual.data()), CellStatus::ok);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      sum += residual[i] * (after_[i] - before_[i]);
    return sum;
  }

  /// energy(x) with x[node][component], J.
  template <class Energy>
  double gain(Energy&& energy) const {
    std::vector<double> x0 = X_, x1 = X_;
    for (std::size_t i = 0; i < X_.size(); ++i)
      x0[i] += before_[i], x1[i] += after_[i];
    return energy(x1) - energy(x0);
  }

 private:
  const Kernel& kernel_;
  int dimension_;
  std::vector<double> X_, before_, after_;
};

template <int D>
Vector<double, D> unit(const std::vector<double>& x, int from) {
  Vector<double, D> result;
  for (int i = 0; i < D; ++i)
    result[i] =
        x[static_cast<std::size_t>((from + 1) * D + i)] - x[static_cast<std::size_t>(from * D + i)];
  const double length = std::sqrt(dot(result, result));
  for (int i = 0; i < D; ++i)
    result[i] /= length;
  return result;
}

CableProperties massless(double slack_width, double compressive_ratio) {
  CableProperties cable;
  cable.mass = 0;
  cable.axial_stiffness = 1e5;
  cable.slack_width = slack_width;
  cable.compressive_ratio = compressive_ratio;
  return cable;
}

template <int D>
void check_axial(double width, double compressive_ratio) {
  const CableProperties cable = massless(width, compressive_ratio);
  const CableKernel<D> kernel({"cable"}, cable, {});
  const auto energy = [&](const std::vector<double>& x) {
    double squared = 0;
    for (std::size_t i = 0; i < D; ++i)
      squared += (x[D + i] - x[i]) * (x[D + i] - x[i]);
    return 0.7 * strain_energy(0.5 * (squared / (0.7 * 0.7) - 1), cable);
  };
  for (unsigned seed = 1; seed < 200; ++seed) {
    const SampleStep step(kernel, D, 0.05, seed);
    const double gain = step.gain(energy);
    EXPECT_NEAR(step.work(0.5), gain, 1e-10 * cable.axial_stiffness * 0.7 * 0.01);
    if (compressive_ratio > 0) continue;  // in compression a turning segment gives energy
    for (const double share : {0.6, 0.9})
      EXPECT_GE(step.work(share), gain - 1e-9);
  }
}

TEST(AxialForce, DoesTheWorkThatItsEnergyGains) {
  for (const double width : {1e-5, 0.02, 0.5}) {  // strains are up to 0.15
    check_axial<2>(width, 0);
    check_axial<3>(width, 0);
    check_axial<2>(width, 0.3);
  }
}

TEST(AxialForce, IsItsLawWhereTheStrainRests) {
  const CableProperties cable = massless(1e-3, 0.1);
  for (const double strain : {-1e-2, -1e-3, -2e-4, 0.0, 7e-4, 1e-3, 3e-2})
    for (const double change : {0.0, 1e-12, -1e-12}) {
      const double tension = slack_tension(strain, cable);
      EXPECT_NEAR(tension_in_step(strain, strain + change, 0.6, cable), tension, 2e-7);
      EXPECT_NEAR(mean_tension(strain, strain + change, cable), tension, 2e-7);
    }
}

template <int D>
void check_bending() {
  const double stiffness = 30;
  const BendingKernel<D> patch({"cable"}, stiffness);
  const ClampKernel<D> clamp({"cable"}, stiffness);
  const auto of_patch = [&](const std::vector<double>& x) {
    return stiffness / 0.7 * (1 - dot(unit<D>(x, 0), unit<D>(x, 1)));
  };
  const auto of_clamp = [&](const std::vector<double>& x) {
    return stiffness / 0.7 * 2 * (1 - unit<D>(x, 0)[0]);
  };
  for (unsigned seed = 1; seed < 200; ++seed) {
    const SampleStep bent(patch, D, 0.3, seed), turned(clamp, D, 0.3, seed);
    EXPECT_NEAR(bent.work(0.5), bent.gain(of_patch), 1e-12 * stiffness);
    EXPECT_NEAR(turned.work(0.5), turned.gain(of_clamp), 1e-12 * stiffness);
    for (const double share : {0.6, 1.0}) {
      EXPECT_GE(bent.work(share), bent.gain(of_patch) - 1e-12);
      EXPECT_GE(turned.work(share), turned.gain(of_clamp) - 1e-12);
    }
  }
}

TEST(BendingMoment, DoesTheWorkThatItsEnergyGains) {
  check_bending<2>();
  check_bending<3>();
}

}  // namespace
}  // namespace hawser
