// Every kernel of every registered module: its tangent against central differences of its residual.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "figure.hpp"
#include "hawser/mesh/generate.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/simulation/registries.hpp"
#include "sample_cell.hpp"

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
    {"mesh-motion", R"(<mesh-motion region="water" reference="total"/>)"},
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

/// One of the region's cells, with linear fields.
double check_kernel(Kernel& kernel, const Mesh& mesh, unsigned seed) {
  const Region& region = mesh.region(kernel.domain());
  const std::vector<Basis> bases(kernel.fields().size(), Basis::p1);
  kernel.bind(region.dimension == mesh.dimension ? tabulate_cell(bases, quadrature(region.shape, 2))
                                                 : CellTabulation());
  const auto cell = static_cast<std::size_t>(seed) % static_cast<std::size_t>(region.size());
  const auto corners = static_cast<std::size_t>(region.vertices_per_cell);
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> coordinates;
  for (std::size_t v = 0; v < corners; ++v)
    for (std::size_t j = 0; j < dimension; ++j)
      coordinates.push_back(
          mesh.coordinates[static_cast<std::size_t>(region.vertices[cell * corners + v]) *
                               dimension +
                           j]);
  return worst_tangent_error(kernel, coordinates, seed);
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
        worst = std::max(worst, check_kernel(*kernel, mesh, seed));
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
