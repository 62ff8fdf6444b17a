// Every kernel of every registered module: its tangent against central differences of its residual.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "figure.hpp"
#include "hawser/mesh/generate.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/simulation/registries.hpp"

namespace hawser {
namespace {

using Snippets = std::multimap<std::string, std::string>;

/// A module's smallest deck, with every optional term switched on.
const Snippets snippets = {
    {"ale-fluid",
     R"(<ale-fluid region="water" density="1000" viscosity="300" body-force="0.3 -9.81">
          <outflow on="outflow" kind="pressure" pressure="40" backflow="0.5"/>
          <outflow on="inflow" kind="traction-free" pressure="40" backflow="0.5"/>
        </ale-fluid>)"},
    {"ale-fluid",
     R"(<ale-fluid region="water" density="1000" viscosity="300"
                   body-force="20*sin(x + 0.5*y + t) - X; 10*x*y"/>)"},
    {"cable",
     R"(<cable region="cable" axial-stiffness="1e7" bending-stiffness="1e5" damping="20"
               axial-damping="1e4" compressive-ratio="0.01" gravity="1 -9.81" clamped="tail"
               load="1e3*sin(x + 2*y + t); 200*X*y">
          <drag current="0.4*cos(y + t); 0.3 + 0.1*x" diameter="0.1" tangential-coefficient="0.4"/>
          <point-load on="tail" force="30*sin(2*x); 20*x*y"/>
        </cable>)"},
    {"mesh-motion", R"(<mesh-motion region="water" reference="incremental"/>)"},
    {"mesh-motion", R"(<mesh-motion region="water" body-force="sin(x)*Y; 2*x*y"/>)"},
    {"heat", R"(<heat region="water" capacity="4e6" conductivity="5"/>)"}};

/// The same in space, for the modules that work there.
const Snippets snippets_in_space = {
    {"cable",
     R"(<cable region="cable" axial-stiffness="1e7" bending-stiffness="1e5" damping="20"
               axial-damping="1e4" compressive-ratio="0.01" gravity="1 2 -9.81" submerged-weight="30"
               clamped="tow-point tail" load="1e3*sin(x + 2*y + t); 200*X*y; 50*z*z">
          <drag current="0.4*cos(y + t); 0.3 + 0.1*x; 0.2*z" diameter="0.1"
                tangential-coefficient="0.4"/>
          <point-load on="tail" force="30*sin(2*x); 20*x*y; t"/>
        </cable>)"}};

ModuleRegistry all_modules_there_are() {
  Registries registries = built_in();
  load_plugin("heat", HAWSER_TEST_PLUGINS, registries);
  return registries.modules;
}

Mesh small_tow() {
  TowBox box;
  box.min = {-2, -3}, box.max = {2, 2};
  box.tail = {0.3, -1};
  box.cable_size = 0.3, box.far_size = 0.5;
  generate_mesh(Communicator(), box, "small_tow.msh");
  return read_mesh(Communicator(), {"small_tow.msh",
                                    {"cable"},
                                    2,
                                    {Domain::facets("outflow"), Domain::facets("inflow"),
                                     Domain::patches("cable"), Domain::ends("cable", "tail")}});
}

Mesh line_in_space() {
  generate_mesh(Communicator(), LineMesh{{0, 0.1, 0.2}, {0.5, 1.1, -1.2}, 5}, "line_in_space.msh");
  return read_mesh(Communicator(), {"line_in_space.msh",
                                    {},
                                    3,
                                    {Domain::patches("cable"), Domain::ends("cable", "tow-point"),
                                     Domain::ends("cable", "tail")}});
}

/// One cell in an admissible state. Rates follow values: rate = slope value + partner v + rest.
class SampleCell {
 public:
  SampleCell(Kernel& kernel, const Mesh& mesh, unsigned seed) : kernel_(kernel), random_(seed) {
    const Region& region = mesh.region(kernel.domain());
    std::vector<Basis> bases;
    first_.push_back(0);
    for (const FieldUse& use : kernel.fields()) {
      const bool quadratic = use.basis == Basis::p2;
      bases.push_back(use.basis);
      first_.push_back(first_.back() + use.components * (region.vertices_per_cell +
                                                         (quadratic ? region.edges_per_cell : 0)));
    }
    kernel.bind(region.dimension == mesh.dimension
                    ? tabulate_cell(bases, quadrature(region.shape, 2))
                    : CellTabulation());

    const auto cell = static_cast<int>(seed) % region.size();
    for (int v = 0; v < region.vertices_per_cell; ++v)
      for (int j = 0; j < mesh.dimension; ++j)
        coordinates_.push_back(mesh.coordinates[at(
            region.vertices[at(cell * region.vertices_per_cell + v)] * mesh.dimension + j)]);
    sample_state();
  }

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
    return kernel_.tangent(input(value_), all_columns, residual.data(), tangent.data());
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  double any() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

  void sample_state() {
    const std::vector<double> amplitudes = kernel_.sample_amplitudes();
    for (std::size_t f = 0; f < kernel_.fields().size(); ++f)
      for (int i = first_[f]; i < first_[f + 1]; ++i) {
        const RateRule rule = kernel_.fields()[f].rate_rule;
        const bool structure = rule == RateRule::quotient && any() > 0;
        amplitude_.push_back(amplitudes[f]);
        value_.push_back(amplitudes[f] * any());
        accepted_.push_back(amplitudes[f] * any());
        rest_.push_back(rule == RateRule::none ? 0 : amplitudes[f] * any());
        slope_.push_back(rule == RateRule::none || structure ? 0 : 3 + any());
        partner_.push_back(structure ? 1 : 0);
      }
  }

  const CellInput& input(const std::vector<double>& value) {
    current_ = value;
    rate_.resize(value.size());
    const int velocity = kernel_.rate_partner();
    fields_.clear();
    for (std::size_t f = 0; f < kernel_.fields().size(); ++f) {
      for (int i = first_[f]; i < first_[f + 1]; ++i) {
        rate_[at(i)] = slope_[at(i)] * current_[at(i)] + rest_[at(i)];
        if (kernel_.fields()[f].rate_rule == RateRule::quotient && velocity >= 0)
          rate_[at(i)] += partner_[at(i)] * current_[at(first_[at(velocity)] + i - first_[f])];
      }
      const std::size_t n = at(first_[f]);
      fields_.push_back({&current_[n], &rate_[n], &accepted_[n], &slope_[n], &partner_[n]});
    }
    input_ = {0, 0.1, coordinates_.data(), fields_.data()};
    return input_;
  }

  Kernel& kernel_;
  std::mt19937 random_;
  std::vector<int> first_;
  std::vector<double> coordinates_, amplitude_, value_, accepted_, rest_, slope_, partner_;
  std::vector<double> current_, rate_;
  std::vector<FieldOnCell> fields_;
  CellInput input_;
};

std::vector<double> central_differences(SampleCell& cell) {
  const int n = cell.unknowns();
  std::vector<double> result(static_cast<std::size_t>(n * n)), plus, minus;
  for (int j = 0; j < n; ++j) {
    const double shift = 1e-5 * cell.amplitude(j);
    EXPECT_EQ(cell.residual(j, shift, plus), CellStatus::ok);
    EXPECT_EQ(cell.residual(j, -shift, minus), CellStatus::ok);
    for (int i = 0; i < n; ++i)
      result[static_cast<std::size_t>(i * n + j)] =
          (plus[static_cast<std::size_t>(i)] - minus[static_cast<std::size_t>(i)]) / (2 * shift);
  }
  return result;
}

void check_kernel(Kernel& kernel, const Mesh& mesh, unsigned seed, double& worst) {
  SampleCell cell(kernel, mesh, seed);
  std::vector<double> alone, residual, tangent;
  ASSERT_EQ(cell.residual(-1, 0, alone), CellStatus::ok);
  ASSERT_EQ(cell.tangent(residual, tangent), CellStatus::ok);
  double scale = 0;
  for (const double entry : alone)
    scale = std::max(scale, std::abs(entry));
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(residual[i], alone[i], 1e-14 * scale);

  const std::vector<double> differences = central_differences(cell);
  const auto& fields = kernel.fields();
  for (std::size_t row = 0; row < fields.size(); ++row)
    for (std::size_t column = 0; column < fields.size(); ++column) {
      double error = 0, size = 0;
      for (int i = cell.first(row); i < cell.first(row + 1); ++i)
        for (int j = cell.first(column); j < cell.first(column + 1); ++j) {
          const auto k = static_cast<std::size_t>(i * cell.unknowns() + j);
          error = std::max(error, std::abs(tangent[k] - differences[k]));
          size = std::max({size, std::abs(tangent[k]), std::abs(differences[k])});
        }
      if (size == 0) continue;
      worst = std::max(worst, error / size);
      EXPECT_LE(error / size, 1e-6) << "block (" << fields[row].name << ", " << fields[column].name
                                    << ") on " << kernel.domain().text() << ", seed " << seed;
    }
}

/// All of a module's snippets, as they are for a mesh of that dimension.
std::vector<PhysicsModule> make_modules(const ModuleRegistry& registry, const std::string& tag,
                                        const Snippets& known, int dimension) {
  std::vector<PhysicsModule> modules;
  const auto range = known.equal_range(tag);
  for (auto snippet = range.first; snippet != range.second; ++snippet) {
    Diagnostics diagnostics;
    const Deck deck = parse_deck(snippet->second, tag, diagnostics);
    modules.push_back(registry.find(tag)->make(deck.root, {dimension}, diagnostics));
    EXPECT_TRUE(diagnostics.ok()) << diagnostics.error_text();
    EXPECT_FALSE(modules.back().kernels.empty());
  }
  return modules;
}

void check_modules(const std::vector<PhysicsModule>& modules, const Mesh& mesh) {
  double worst = 0;
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels) {
      ASSERT_EQ(kernel->dimension(), mesh.dimension);
      for (unsigned seed = 1; seed <= 10; ++seed)
        check_kernel(*kernel, mesh, seed, worst);
    }
  const std::string& tag = modules.front().name;
  const std::string where = mesh.dimension == 3 ? " in space" : "";
  record(
      {"jacobian." + tag + (mesh.dimension == 3 ? ".space" : ""), "Invariants",
       "tangent of <" + tag + ">" + where + " against central differences, worst block, relative",
       "1", worst, 0, 1e-6, "truncation and round-off of the differences"});
}

TEST(Jacobian, IsTheDerivativeOfTheResidualInEveryRegisteredModule) {
  const Mesh mesh = small_tow();
  const ModuleRegistry registry = all_modules_there_are();
  for (const std::string& tag : registry.tags()) {
    SCOPED_TRACE("module <" + tag + ">");
    const auto modules = make_modules(registry, tag, snippets, 2);
    if (modules.empty())
      ADD_FAILURE() << "give it a snippet in this test";
    else
      check_modules(modules, mesh);
  }
}

TEST(Jacobian, IsTheDerivativeOfTheResidualInEveryModuleThatWorksInSpace) {
  const Mesh mesh = line_in_space();
  const ModuleRegistry registry = all_modules_there_are();
  for (const std::string& tag : registry.tags()) {
    SCOPED_TRACE("module <" + tag + ">");
    const auto in_space = make_modules(registry, tag, snippets_in_space, 3);
    if (!in_space.empty()) {
      check_modules(in_space, mesh);
      continue;
    }
    for (const PhysicsModule& module : make_modules(registry, tag, snippets, 3))
      for (const auto& kernel : module.kernels)
        EXPECT_EQ(kernel->dimension(), 2) << "give it a snippet in space in this test";
  }
}

}  // namespace
}  // namespace hawser
