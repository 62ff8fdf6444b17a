// A report from outside of the core: the kinetic energy of what moves in a body of triangles, J per
// metre of depth. With linear velocities the integral of v.v over a triangle is A/12 (sum of
// v_k.v_k + |sum of v_k|^2), exactly.
#include <cmath>

#include "hawser/fields/look_up.hpp"
#include "hawser/physics/field_use.hpp"
#include "hawser/report/plugin.hpp"

namespace {

using namespace hawser;

struct Energy {
  std::string name;
  Located<std::string> region;
  double density = 1000;
  static Spec<Energy> spec() {
    return Spec<Energy>("energy", "Reports the kinetic energy of a body.")
        .attribute("name", &Energy::name, required(), "Start of the quantity's name.")
        .attribute("region", &Energy::region, required(), "Body of triangles.")
        .attribute("density", &Energy::density, "kg/m^3", positive(), "Mass density.");
  }
};

class EnergyReport : public Report {
 public:
  using Parameters = Energy;
  EnergyReport(const Energy& deck, const ReportContext& context, Diagnostics& faults)
      : deck_(deck),
        dofs_(context.dofs()),
        body_(
            find_region_of({CellShape::triangle}, context.mesh(), deck.region, "<energy>", faults)),
        velocity_(find_field(dofs_, {field_name::velocity, deck.region.location}, faults)),
        displacement_(dofs_.find(field_name::displacement)) {}

  std::vector<Column> columns() const override { return {{deck_.name + "_kinetic_energy", "J/m"}}; }

 private:
  double at(const Step& step, int field, LocalIndex vertex, LocalIndex j) const {
    const LocalIndex row = field < 0 ? -1 : dofs_.first_row(field, PointKind::vertex, vertex);
    return row < 0 ? 0 : step.end.value[static_cast<std::size_t>(row + j)];
  }
  std::vector<double> measure(const Step& step) override {
    const Mesh& mesh = dofs_.mesh();
    double energy = 0;
    for (std::size_t cell = 0; cell < body_->cell_ids.size(); ++cell) {
      if (body_->cell_owners[cell] != mesh.communicator.rank()) continue;
      double x[3][2], sum[2] = {}, squares = 0;
      for (std::size_t k = 0; k < 3; ++k)
        for (LocalIndex j = 0; j < 2; ++j) {
          const LocalIndex vertex = body_->vertices[3 * cell + k];
          const double v = at(step, velocity_, vertex, j);
          x[k][j] = mesh.coordinates[static_cast<std::size_t>(2 * vertex + j)] +
                    at(step, displacement_, vertex, j);
          sum[j] += v;
          squares += v * v;
        }
      const double area = 0.5 * ((x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) -
                                 (x[2][0] - x[0][0]) * (x[1][1] - x[0][1]));
      energy += deck_.density / 24 * area * (squares + sum[0] * sum[0] + sum[1] * sum[1]);
    }
    return {mesh.communicator.sum(energy)};
  }

  Energy deck_;
  const DofMap& dofs_;
  const Region* body_;
  int velocity_, displacement_;
};

}  // namespace

HAWSER_REPORT_PLUGIN(reports) { reports.add<EnergyReport>(); }
