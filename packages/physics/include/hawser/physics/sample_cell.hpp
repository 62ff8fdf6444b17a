#pragma once
// A kernel on one cell in a random admissible state, and its tangent against differences of its
// residual: for tests, and for hawser jacobian.
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "hawser/physics/kernel.hpp"

namespace hawser {

/// The kernel's own, and of fields that only the sources of its properties read 10, of places 0.05
/// m. PluginError when the kernel has more than fields.
std::vector<double> sample_amplitudes(const Kernel& kernel);

/// One cell in an admissible state, with something to remember, at the end of a step or within it,
/// its law on its own branch or on one that is held. Rates follow values: rate = slope value +
/// partner v
/// + rest.
class SampleCell {
 public:
  /// Of a kernel that is bound; `coordinates` are [vertex][dimension], m. `amplitudes`: of each
  /// field; of those that only the sources of properties read it is 10, of places 0.05 m.
  SampleCell(const Kernel& kernel, std::vector<double> coordinates, unsigned seed,
             std::vector<double> amplitudes)
      : kernel_(kernel),
        amplitudes_(std::move(amplitudes)),
        random_(seed),
        coordinates_(std::move(coordinates)),
        share_(seed % 2 == 0 ? 1 : 0.5 + 0.05 * (seed % 10)),
        bounds_energy_(seed % 3 != 0),
        held_(seed % 5 == 0) {
    first_.push_back(0);
    for (std::size_t f = 0; f < kernel.fields().size(); ++f)
      first_.push_back(first_.back() + kernel.fields()[f].components * kernel.nodes(f));
    sample_state();
  }
  SampleCell(const Kernel& kernel, std::vector<double> coordinates, unsigned seed)
      : SampleCell(kernel, std::move(coordinates), seed, sample_amplitudes(kernel)) {}

  const Kernel& kernel() const { return kernel_; }

  int unknowns() const { return first_.back(); }
  int first(std::size_t field) const { return first_[field]; }
  double amplitude(int unknown) const { return amplitude_[at(unknown)]; }

  CellStatus residual(int shifted, double shift, std::vector<double>& result) {
    std::vector<double> value = value_;
    if (shifted >= 0) value[at(shifted)] += shift;
    result.resize(at(unknowns()));
    return kernel_.residual(input(value), result.data());
  }
  CellStatus tangent(std::vector<double>& residual, std::vector<double>& tangent) {
    residual.resize(at(unknowns()));
    tangent.resize(residual.size() * residual.size());
    return kernel_.tangent(input(value_), residual.data(), tangent.data());
  }
  /// Power residual . velocity, W, and what the terms make of it, supplied ones negative.
  std::pair<double, double> power() {
    std::vector<double> residual(at(unknowns()));
    double power = kernel_.residual(input(value_), residual.data()) == CellStatus::ok
                       ? 0
                       : std::numeric_limits<double>::quiet_NaN();
    for (std::size_t f = 0; f < kernel_.fields().size(); ++f)
      if (kernel_.fields()[f].name == std::string_view("velocity"))
        for (int i = first_[f]; i < first_[f + 1]; ++i)
          power += residual[at(i)] * value_[at(i)];
    const std::vector<double> terms = powers();
    return {power, std::accumulate(terms.begin(), terms.end(), 0.0)};
  }
  std::vector<double> powers() {
    std::vector<double> terms(kernel_.energy_terms().size());
    kernel_.powers(input(value_), terms.data());
    return terms;
  }
  /// Once all values have gone on for `time` s with the present rates.
  std::vector<double> energies_after(double time) {
    input(value_);
    std::vector<double> value = value_, terms(kernel_.energy_terms().size());
    for (std::size_t i = 0; i < value.size(); ++i)
      value[i] += time * rate_[i];
    kernel_.energies(input(value), terms.data());
    return terms;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  double any() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

  void sample_state() {
    for (std::size_t f = 0; f < kernel_.fields().size(); ++f)
      for (int i = first_[f]; i < first_[f + 1]; ++i) {
        const RateRule rule = kernel_.fields()[f].rate_rule;
        const int followed = kernel_.rate_partner(f);
        // Structures have both fields at their nodes.
        const bool has_partner =
            followed < 0 || i - first_[f] < first_[at(followed) + 1] - first_[at(followed)];
        const bool structure = rule == RateRule::quotient && has_partner && any() > 0;
        amplitude_.push_back(amplitudes_[f]);
        value_.push_back(amplitudes_[f] * any());
        accepted_.push_back(amplitudes_[f] * any());
        rest_.push_back(rule == RateRule::none ? 0 : amplitudes_[f] * any());
        slope_.push_back(rule == RateRule::none || structure ? 0 : 3 + any());
        partner_.push_back(structure ? 1 : 0);
      }
    for (int i = 0; i < kernel_.memory_per_cell(); ++i)
      memory_.push_back(any());
  }

  const CellInput& input(const std::vector<double>& value) {
    current_ = value;
    rate_.resize(value.size());
    fields_.clear();
    for (std::size_t f = 0; f < kernel_.fields().size(); ++f) {
      const int followed = kernel_.rate_partner(f);
      for (int i = first_[f]; i < first_[f + 1]; ++i) {
        rate_[at(i)] = slope_[at(i)] * current_[at(i)] + rest_[at(i)];
        if (followed >= 0 && partner_[at(i)] != 0)
          rate_[at(i)] += partner_[at(i)] * current_[at(first_[at(followed)] + i - first_[f])];
      }
      const std::size_t n = at(first_[f]);
      fields_.push_back({&current_[n], &rate_[n], &accepted_[n], &slope_[n], &partner_[n]});
    }
    input_ = {0,   0.1,    coordinates_.data(), fields_.data(), memory_.data(),
              0.1, share_, bounds_energy_,      held_};
    return input_;
  }

  const Kernel& kernel_;
  std::vector<double> amplitudes_;
  std::mt19937 random_;
  std::vector<double> coordinates_;
  double share_;
  bool bounds_energy_, held_;
  std::vector<int> first_;
  std::vector<double> amplitude_, value_, accepted_, rest_, slope_, partner_, memory_;
  std::vector<double> current_, rate_;
  std::vector<FieldOnCell> fields_;
  CellInput input_;
};

/// The rows of one field by the unknowns of another: what the tangent has and what central
/// differences have.
struct TangentBlock {
  std::size_t row = 0, column = 0;     ///< fields of the kernel
  double error = 0;                    ///< largest difference over the block's largest entry
  double tangent = 0, difference = 0;  ///< the entries that differ most
};

/// Every block that is not zero both ways; nothing when a state is not admissible.
std::optional<std::vector<TangentBlock>> compare_tangent(SampleCell& cell);

}  // namespace hawser
