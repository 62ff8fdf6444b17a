// Temperature carried by the flow, c = v - w, and conducted, on the moving mesh:
//   rho c_p (dT/dt|_X + c . grad T) = div(k grad T).
#include "hawser/physics/moving_point_kernel.hpp"
#include "hawser/physics/plugin.hpp"

namespace {

using namespace hawser;

struct Heat {
  Domain region;
  double capacity = 4.18e6, conductivity = 0.6;
  static Spec<Heat> spec() {
    return Spec<Heat>("heat", "Heat carried by the flow and conducted.")
        .attribute("region", &Heat::region, required(), "Regions that conduct.")
        .attribute("capacity", &Heat::capacity, "J/(m^3 K)", positive(), "Heat per volume.")
        .attribute("conductivity", &Heat::conductivity, "W/(m K)", positive(), "Of Fourier's law.");
  }
};

class HeatKernel : public MovingPointKernel<HeatKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr std::array<FieldUse, 3> uses = {
      FieldUse{"temperature", "K", "W/m", 1, RateRule::dynamic}.as(Role::adds,
                                                                   need::rate | need::gradient),
      StandardFields<2>::velocity.as(Role::reads_if_solved, need::value),
      StandardFields<2>::displacement.as(Role::reads_if_solved, need::rate | need::gradient)};
  static constexpr Slot<0> temperature{};
  static constexpr Slot<1> velocity{};
  static constexpr Slot<2> displacement{};

  explicit HeatKernel(const Heat& heat) : MovingPointKernel(heat.region), heat_(heat) {}

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    using T = typename Point::Number;
    const auto& gradient = at[temperature].gradient;
    T change = at[temperature].rate;
    for (int i = 0; i < 2; ++i)
      change += (at[velocity].value[i] - at[displacement].rate[i]) * gradient[i];
    out[temperature].source = heat_.capacity * change;
    for (int i = 0; i < 2; ++i)
      out[temperature].flux[i] = heat_.conductivity * gradient[i];
  }

  std::vector<double> sample_amplitudes() const override { return {10, 1, 0.05}; }

 private:
  Heat heat_;
};

}  // namespace

HAWSER_PLUGIN(registry) {
  registry.add<Heat>([](const Heat& heat) {
    PhysicsModule module{"heat", "heat", {}, {}};
    module.kernels.push_back(std::make_unique<HeatKernel>(heat));
    return module;
  });
}
