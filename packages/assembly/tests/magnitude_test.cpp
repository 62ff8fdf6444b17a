// The scale against which a row's residual is judged.
#include <gtest/gtest.h>

#include <cmath>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/assembler.hpp"
#include "hawser/assembly/field_table.hpp"
#include "hawser/physics/element_kernel.hpp"
#include "hawser/physics/point_kernel.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

/// A fluid without viscosity in a field of gravity: div (-p I) = rho g.
class Hydrostatics : public PointKernel<Hydrostatics> {
 public:
  static constexpr int dimension = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<2>::velocity.as(Role::adds, need::gradient),
      StandardFields<2>::pressure.as(Role::adds, need::value)};
  static constexpr Slot<0> velocity{};
  static constexpr Slot<1> pressure{};

  explicit Hydrostatics(double weight) : PointKernel("water"), weight_(weight) {}

  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    out[velocity].source[1] = weight_;
    for (int i = 0; i < 2; ++i)
      out[velocity].flux(i, i) = -1.0 * at[pressure].value;
    out[pressure].source = trace(at[velocity].gradient);
  }

 private:
  double weight_;  // N/m^3, downward
};

/// What stands on the wall: a pressure p0.
class Outside : public ElementKernel<Outside> {
 public:
  static constexpr int dimension = 2;
  static constexpr CellShape shape = CellShape::triangle;
  static constexpr int node_count = 3;
  static constexpr std::array<FieldUse, 1> uses = {
      StandardFields<2>::velocity.as(Role::adds, need::value)};

  explicit Outside(double pressure) : ElementKernel(Domain::facets("wall")), pressure_(pressure) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    const double normal[2] = {at.coordinate(1, 1) - at.coordinate(0, 1),
                              at.coordinate(0, 0) - at.coordinate(1, 0)};
    for (int a = 0; a < 2; ++a)
      for (int i = 0; i < 2; ++i)
        out[at.index(0, a, i)] += 0.5 * pressure_ * normal[i];
  }

 private:
  double pressure_;
};

struct Row {
  double residual, magnitude;
  int component;
  bool in_the_middle;
};

/// The velocity rows of water under `level`, with p = level + slope (2 - y).
std::vector<Row> rows(double level, double weight, double slope) {
  std::vector<PhysicsModule> modules;
  modules.push_back(module_with("water", std::make_unique<Hydrostatics>(weight)));
  modules[0].kernels.push_back(std::make_unique<Outside>(level));
  std::vector<Domain> domains;
  for (const auto& kernel : modules[0].kernels)
    domains.push_back(kernel->domain());
  const Mesh mesh = read_text(Communicator(), grid(2, 2).in_format("4.1"), {}, domains);
  const DofMap dofs(mesh, gather_fields(modules).fields);
  const Assembler assembler(dofs, modules);
  State state;
  for (auto* array :
       {&state.value, &state.rate, &state.accepted, &state.rate_slope, &state.rate_partner})
    array->assign(static_cast<std::size_t>(dofs.rows()), 0);
  const int pressure = dofs.find("pressure");
  for (LocalIndex row = 0; row < dofs.rows(); ++row) {
    double x[2];
    dofs.position(row, x);
    if (dofs.info(row).field == pressure)
      state.value[static_cast<std::size_t>(row)] = level + slope * (2 - x[1]);
  }
  std::vector<double> total, magnitude;
  assembler.residual(state, total, magnitude);
  std::vector<Row> result;
  for (LocalIndex row = 0; row < dofs.owned(); ++row) {
    if (dofs.info(row).field == pressure) continue;
    double x[2];
    dofs.position(row, x);
    const auto r = static_cast<std::size_t>(row);
    result.push_back({total[r], magnitude[r], dofs.info(row).component, x[0] == 1 && x[1] == 1});
  }
  return result;
}

TEST(Magnitude, DoesNotKnowTheLevelOfAPressure) {
  const auto low = rows(0, 3, 2), high = rows(1e7, 3, 2);
  ASSERT_EQ(low.size(), high.size());
  for (std::size_t i = 0; i < low.size(); ++i) {
    EXPECT_NEAR(high[i].residual, low[i].residual, 1e-7);
    EXPECT_NEAR(high[i].magnitude, low[i].magnitude, 1e-7);
  }
}

// At the vertex in the middle: the weight of the water there, and the resultant of the pressure
// that carries it.
TEST(Magnitude, IsWhatCancelsInARow) {
  for (const Row& row : rows(1e7, 3, 3)) {
    if (!row.in_the_middle) continue;
    EXPECT_NEAR(row.residual, 0, 1e-7);
    EXPECT_NEAR(row.magnitude, row.component == 0 ? 0 : 3 + 3, 1e-7);
  }
}

}  // namespace
}  // namespace hawser
