// A module that does what its parameter `harm` says.
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include "hawser/physics/moving_point_kernel.hpp"
#include "hawser/physics/plugin.hpp"

namespace {

using namespace hawser;

struct Harmful {
  Domain region;
  std::string harm;
  static Spec<Harmful> spec() {
    return Spec<Harmful>("harmful", "Does harm.")
        .attribute("region", &Harmful::region, required(), "Where it does it.")
        .attribute("harm", &Harmful::harm, required(), "What it does.");
  }
};

constexpr FieldUse temperature_use =
    FieldUse{"temperature", "K", "W/m", 1, RateRule::dynamic}.as(Role::adds, need::rate);

class HarmfulKernel : public MovingPointKernel<HarmfulKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr std::array<FieldUse, 3> uses = {
      temperature_use, StandardFields<2>::velocity.as(Role::reads_if_solved, need::value),
      StandardFields<2>::displacement.as(Role::reads_if_solved, need::rate | need::gradient)};
  static constexpr Slot<0> temperature{};
  static constexpr Slot<2> displacement{};

  explicit HarmfulKernel(const Harmful& given)
      : MovingPointKernel(given.region), harm_(given.harm) {
    if (harm_ == "hang")
      for (volatile bool on = true; on;) {
      }
    if (harm_ == "crash") std::raise(SIGSEGV);
    if (harm_ == "exit") std::_Exit(0);
    if (harm_ == "throw") throw std::runtime_error("no memory for the tables");
    if (harm_ == "throw-a-number") throw 7;
  }

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    if (harm_ == "throw-later") throw std::runtime_error("out of luck");
    out[temperature].source = at[temperature].rate * (harm_ == "nan" ? std::nan("") : 1);
  }

  std::vector<double> sample_amplitudes() const override { return {10, 1, 0.05}; }

 private:
  std::string harm_;
};

/// Asks for a field by a wrong name.
class MisledKernel : public MovingPointKernel<MisledKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr std::array<FieldUse, 3> uses = {
      temperature_use,
      FieldUse{"velocty", "m/s", "N/m", 2, RateRule::dynamic}.as(Role::reads, need::value),
      StandardFields<2>::displacement.as(Role::reads_if_solved, need::rate | need::gradient)};
  static constexpr Slot<0> temperature{};
  static constexpr Slot<1> velocity{};
  static constexpr Slot<2> displacement{};

  explicit MisledKernel(const Harmful& given) : MovingPointKernel(given.region) {}

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    out[temperature].source = at[temperature].rate + at[velocity].value[0];
  }

  std::vector<double> sample_amplitudes() const override { return {10, 1, 0.05}; }
};

}  // namespace

HAWSER_PLUGIN(registry) {
  registry.add<Harmful>([](const Harmful& given) {
    PhysicsModule module{"harm", "heat", {}, {}};
    if (given.harm == "wrong-field")
      module.kernels.push_back(std::make_unique<MisledKernel>(given));
    else
      module.kernels.push_back(std::make_unique<HarmfulKernel>(given));
    return module;
  });
}
