// A module and a report from one plug-in: a tracer that decays, dc/dt = -rate c, in a body at rest,
// and the integral of any formula over a region, as a report of one's own may take it.
#include <optional>

#include "hawser/base/exact_sum.hpp"
#include "hawser/fields/look_up.hpp"
#include "hawser/fields/region_sampling.hpp"
#include "hawser/physics/plugin.hpp"
#include "hawser/physics/point_kernel.hpp"
#include "hawser/report/plugin.hpp"

namespace {

using namespace hawser;

struct Decay {
  Domain region;
  double rate = 1;
  static Spec<Decay> spec() {
    return Spec<Decay>("decay", "A tracer that decays where it is.")
        .attribute("region", &Decay::region, required(), "Bodies.")
        .attribute("rate", &Decay::rate, "1/s", positive(), "Of decay.");
  }
};

class DecayKernel : public PointKernel<DecayKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr std::array<FieldUse, 1> uses = {
      FieldUse{"tracer", "kg/m^3", "kg/(m s)", 1, RateRule::dynamic}.as(Role::adds,
                                                                        need::value | need::rate)};
  static constexpr Slot<0> tracer{};

  explicit DecayKernel(const Decay& decay) : PointKernel(decay.region), rate_(decay.rate) {}

  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    out[tracer].source = at[tracer].rate + rate_ * at[tracer].value;
  }

  /// For the fields on disk: what a cell holds, by the mean of its nodes.
  std::vector<Quantity> quantities() const override { return {{"cell_mean", "kg/m^3"}}; }
  void evaluate(const CellInput& cell, double* values) const override {
    values[0] = 0;
    for (int a = 0; a < nodes(0); ++a)
      values[0] += cell.fields[0].value[a] / nodes(0);
  }

 private:
  double rate_;
};

struct Amount {
  std::string name;
  Located<std::string> region;
  FieldExpression of;
  static Spec<Amount> spec() {
    return Spec<Amount>("amount", "Reports how much there is of something.")
        .attribute("name", &Amount::name, required(), "Name of the quantity.")
        .attribute("region", &Amount::region, required(), "Body.")
        .attribute("of", &Amount::of, "kg/m^3", required() && any(), "Formula of fields.");
  }
};

class AmountReport : public Report {
 public:
  using Parameters = Amount;
  AmountReport(const Amount& deck, const ReportContext& context, Diagnostics& faults)
      : name_(deck.name), communicator_(context.mesh().communicator) {
    const Region* const region = find_region(context.mesh(), deck.region, faults);
    if (region != nullptr)
      sampling_.emplace(context.dofs(), *region, deck.of, -1, quadrature, faults);
  }
  std::vector<Column> columns() const override { return {{name_, "kg/m"}}; }

 private:
  std::vector<double> measure(const Step& step) override {
    std::vector<double> terms;
    communicator_.together([&] {
      sampling_->visit(step.end, [&](const RegionSampling::Sample& at) {
        terms.push_back(at.weight * at.value);
      });
    });
    return {exact_sum(communicator_, terms)};
  }

  std::string name_;
  Communicator communicator_;
  std::optional<RegionSampling> sampling_;
};

}  // namespace

HAWSER_PLUGIN(registry) {
  registry.add<Decay>([](const Decay& decay) {
    PhysicsModule module{"decay", "decay", {}, {}};
    module.kernels.push_back(std::make_unique<DecayKernel>(decay));
    return module;
  });
}

HAWSER_REPORT_PLUGIN(reports) { reports.add<AmountReport>(); }
