// The links of a chain under its own weight between two points.
//
// With the unit of force the weight of a link, half of which hangs at either of its ends, link k
// carries F_k = F + (k - (n-1)/2) e, e upward, and lies along it. The way between the ends,
// sum l F_k/|F_k| = c, is the condition for the least of the convex function
// sum l |F_k| - F.c: Newton's method with a line search finds F from anywhere.
#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/mesh/line_system.hpp"

namespace hawser {
namespace {

/// In the plane of the chain: along the horizontal and upward.
struct Pair {
  double along = 0, up = 0;
};

class Chain {
 public:
  Chain(Pair way, double length, int links) : way_(way), link_(length / links), links_(links) {
    const double distance = std::hypot(way.along, way.up);
    // Of a shallow catenary, of which the length is more than the distance by w^2 c^3/(24 H^2).
    const double pull = links * std::sqrt(distance / (24 * (length - distance)));
    force_ = {pull * way.along / distance, pull * way.up / distance};
  }

  /// False when no digits are left to find it with.
  bool solve() {
    constexpr int most = 200;
    constexpr double accuracy = 1e-13;
    for (int i = 0; i < most; ++i) {
      const Pair gap = gap_at(force_);
      if (std::hypot(gap.along, gap.up) < accuracy * link_ * links_) return true;
      if (!improve(gap)) return std::hypot(gap.along, gap.up) < 1e3 * accuracy * link_ * links_;
    }
    return false;
  }

  Pair direction(int link) const { return unit(carried(force_, link)); }

 private:
  Pair carried(Pair force, int link) const {
    return {force.along, force.up + link - 0.5 * (links_ - 1)};
  }
  static Pair unit(Pair force) {
    const double size = std::hypot(force.along, force.up);
    return {force.along / size, force.up / size};
  }

  /// Gradient of the function.
  Pair gap_at(Pair force) const {
    Pair sum;
    for (int k = 0; k < links_; ++k) {
      const Pair t = unit(carried(force, k));
      sum.along += t.along;
      sum.up += t.up;
    }
    return {link_ * sum.along - way_.along, link_ * sum.up - way_.up};
  }

  double function_at(Pair force) const {
    double sum = 0;
    for (int k = 0; k < links_; ++k) {
      const Pair F = carried(force, k);
      sum += std::hypot(F.along, F.up);
    }
    return link_ * sum - force.along * way_.along - force.up * way_.up;
  }

  bool improve(Pair gap) {
    double aa = 0, au = 0, uu = 0;  // Hessian
    for (int k = 0; k < links_; ++k) {
      const Pair F = carried(force_, k), t = unit(F);
      const double by = link_ / std::hypot(F.along, F.up);
      aa += by * t.up * t.up;
      au -= by * t.up * t.along;
      uu += by * t.along * t.along;
    }
    const double determinant = aa * uu - au * au;
    if (!(determinant > 0)) return false;
    const Pair way = {-(uu * gap.along - au * gap.up) / determinant,
                      -(aa * gap.up - au * gap.along) / determinant};
    const double slope = gap.along * way.along + gap.up * way.up, now = function_at(force_);
    for (double share = 1; share > 1e-12; share /= 2) {
      const Pair next = {force_.along + share * way.along, force_.up + share * way.up};
      const Pair left = gap_at(next);
      // Close to the least the function is flat to round-off, and the gap tells.
      if (function_at(next) > now + 1e-4 * share * slope &&
          std::hypot(left.along, left.up) >= std::hypot(gap.along, gap.up))
        continue;
      force_ = next;
      return true;
    }
    return false;
  }

  Pair way_;
  double link_;  // m
  int links_;
  Pair force_;  // of the middle of the chain, weights of a link
};

}  // namespace

std::vector<std::vector<double>> hang_chain(const std::vector<double>& from,
                                            const std::vector<double>& to, double length, int links,
                                            const std::vector<double>& down) {
  const std::size_t dimension = from.size();
  std::vector<double> level(dimension);  // the way between the ends, then its level direction
  double rise = 0, run = 0;
  for (std::size_t j = 0; j < dimension; ++j) {
    level[j] = to[j] - from[j];
    rise -= level[j] * down[j];
  }
  for (std::size_t j = 0; j < dimension; ++j) {
    level[j] += rise * down[j];
    run += level[j] * level[j];
  }
  run = std::sqrt(run);
  // A run of less than a link may leave a link without any force.
  if (!(run >= length / links) || !(length > std::hypot(run, rise)) || links < 2)
    throw MeshError("a chain of " + std::to_string(links) + " links of " + write_value(length) +
                    " m has no place between its ends");
  for (double& component : level)
    component /= run;
  Chain chain({run, rise}, length, links);
  if (!chain.solve())
    throw MeshError("the place of a chain of " + write_value(length) + " m over a way of " +
                    write_value(std::hypot(run, rise)) + " m was not found");
  std::vector<std::vector<double>> joints = {from};
  for (int k = 0; k + 1 < links; ++k) {
    const Pair t = chain.direction(k);
    joints.push_back(joints.back());
    for (std::size_t j = 0; j < dimension; ++j)
      joints.back()[j] += length / links * (t.along * level[j] - t.up * down[j]);
  }
  joints.push_back(to);
  return joints;
}

}  // namespace hawser
