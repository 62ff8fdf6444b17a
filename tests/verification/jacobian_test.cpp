// Every kernel of every registered module: its tangent against central differences of its residual.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "figure.hpp"
#include "hawser/assembly/connect_properties.hpp"
#include "hawser/mesh/generate.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/simulation/registries.hpp"
#include "sample_cell.hpp"

namespace hawser {
namespace {

using Snippets = std::multimap<std::string, std::string>;

/// Whose kernels those that only supply properties are tried in.
const std::string water_and_heat =
    R"x(<ale-fluid region="water" density="1000" viscosity="300"><outflow on="outflow" kind="pressure"/></ale-fluid>
       <heat-transport region="water" capacity="4e6" conductivity="5"/>)x";

/// A module's smallest deck, with every optional term switched on; further elements, with which it
/// works together, behind it.
const Snippets snippets = {
    {"ale-fluid",
     R"x(<ale-fluid region="water" density="1000" viscosity="300" body-force="0.3 -9.81">
          <outflow on="outflow" kind="pressure" pressure="40" backflow="0.5"/>
          <outflow on="inflow" kind="traction-free" pressure="40" backflow="0.5"/>
        </ale-fluid>)x"},
    {"ale-fluid",
     R"x(<ale-fluid region="water" density="1000" viscosity="300"
                   body-force="20*sin(x + 0.5*y + t) - X; 10*x*y"/>)x"},
    {"ale-fluid",
     R"x(<ale-fluid region="water" density="1000" viscosity="300" elements="taylor-hood" grad-div="20"
                   body-force="20*sin(x + 0.5*y + t) - X; 10*x*y">
          <outflow on="outflow" kind="pressure" pressure="40" backflow="0.5"/>
        </ale-fluid>)x"},
    {"cable",
     R"x(<cable region="cable" axial-stiffness="1e7" bending-stiffness="1e5" damping="20"
               axial-damping="1e4" compressive-ratio="0.01" gravity="1 -9.81" clamped="tail"
               load="1e3*sin(x + 2*y + t); 200*X*y">
          <drag current="0.4*cos(y + t); 0.3 + 0.1*x" diameter="0.1" tangential-coefficient="0.4"/>
          <point-load on="tail" force="30*sin(2*x); 20*x*y"/>
        </cable>)x"},
    {"body",
     R"x(<body on="tail" mass="30" added-mass="20" gravity="1 -9.81" submerged-weight="70" drag-area="0.4"
               current="0.4*cos(y + t); 0.3 + 0.1*x"><lift direction="1 2" area="0.3"/></body>
         <cable region="cable"/>)x"},
    {"sea-bed",
     R"x(<sea-bed region="cable" level="1 + 0.2*x" stiffness="1e3" friction="0.4"/><cable region="cable"/>)x"},
    {"mesh-motion", R"x(<mesh-motion region="water" reference="incremental"/>)x"},
    {"mesh-motion", R"x(<mesh-motion region="water" reference="total"/>)x"},
    {"mesh-motion", R"x(<mesh-motion region="water" body-force="sin(x)*Y; 2*x*y"/>)x"},
    {"mesh-motion", R"x(<mesh-motion region="water" stiffness="2 + x*dx(displacement_y)"/>)x"},
    {"ale-fluid",
     R"x(<ale-fluid region="water" density="1000 + 3*temperature" viscosity="300 + 2*temperature^2 + dx(temperature)"
                   body-force="velocity_y*temperature; dy(temperature) - x"/>)x" +
         water_and_heat.substr(water_and_heat.find("<heat"))},
    {"buoyancy",
     R"x(<buoyancy region="water" expansion="2e-4" reference="20"/>)x" + water_and_heat},
    {"eddy-viscosity",
     R"x(<eddy-viscosity region="water" model="smagorinsky"/>)x" + water_and_heat},
    {"eddy-viscosity",
     R"x(<eddy-viscosity region="water" model="mixing-length" length="0.1 + 0.02*x*y"/>)x" +
         water_and_heat},
    {"porous-zone",
     R"x(<porous-zone region="water" linear="0.3" quadratic="0.7"/>)x" + water_and_heat},
    {"property",
     R"x(<property name="viscosity" region="water" value="3*temperature^2" adds="true"/>)x" +
         water_and_heat},
    {"heat-transport",
     R"x(<heat-transport region="water" capacity="4e6 + temperature" conductivity="5 + 0.1*temperature"
                        source="sin(temperature)*x"/>)x"},
    {"scalar-transport",
     R"x(<scalar-transport region="water" field="dye" unit="kg/m^3" diffusivity="0.5 + 0.01*dye^2"
                          source="x*y - dye" decay="0.2 + 0.01*dx(dye)"/>)x"},
    {"solid",
     R"x(<solid region="water" density="800" young-modulus="1e5" poisson-ratio="0.4" damping="0.3"
               viscosity="50" body-force="0.3 -9.81">
          <load on="outflow" traction="30*x; 20*x*y + t" pressure="40*y"/>
        </solid>)x"},
    {"solid",
     R"x(<solid region="water" law="neo-hookean" density="800 + x" young-modulus="1e5 + 1e4*dx(velocity_y)"
               body-force="0.3*velocity_x; -9.81*x"/>)x"},
    {"heat", R"x(<heat region="water" capacity="4e6" conductivity="5"/>)x"}};

/// The same in space, for the modules that work there.
const Snippets snippets_in_space = {
    {"cable",
     R"(<cable region="cable" axial-stiffness="1e7" bending-stiffness="1e5" damping="20"
               axial-damping="1e4" compressive-ratio="0.01" gravity="1 2 -9.81" submerged-weight="30"
               clamped="tow-point tail" load="1e3*sin(x + 2*y + t); 200*X*y; 50*z*z">
          <drag current="0.4*cos(y + t); 0.3 + 0.1*x; 0.2*z" diameter="0.1"
                tangential-coefficient="0.4"/>
          <point-load on="tail" force="30*sin(2*x); 20*x*y; t"/>
        </cable>)"},
    {"body",
     R"(<body on="tail" mass="30" added-mass="20" gravity="1 2 -9.81" drag-area="0.4"
              current="0.4*cos(y + t); 0.3 + 0.1*x; z*z"><lift direction="1 2 -3" area="0.3"/>
              <lift direction="0 0 -1" area="0.2"/></body>
        <cable region="cable"/>)"},
    {"sea-bed",
     R"x(<sea-bed region="cable" level="1 + 0.2*sin(x + y)" stiffness="1e3" friction="0.4"
                     creep-speed="0.3"/><cable region="cable"/>)x"}};

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

/// One of the region's cells, with the bases that the kernel asks for.
double check_kernel(Kernel& kernel, const Mesh& mesh, unsigned seed) {
  const Region& region = mesh.region(kernel.domain());
  std::vector<Basis> bases;
  for (const FieldUse& use : kernel.fields())
    bases.push_back(use.basis.value_or(Basis::p1));
  const bool on_facets = region.dimension < mesh.dimension;
  if (traits(region.shape).dimension < mesh.dimension)
    kernel.bind({});
  else
    kernel.bind(tabulate_cell(
        bases, on_facets ? facet_quadrature(region.shape, 2) : quadrature(region.shape, 2)));
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

/// Each of a module's snippets, as they are for a mesh of that dimension: it, and what works with
/// it.
std::vector<std::vector<PhysicsModule>> make_modules(const ModuleRegistry& registry,
                                                     const std::string& tag, const Snippets& known,
                                                     int dimension) {
  std::vector<std::vector<PhysicsModule>> runs;
  const auto range = known.equal_range(tag);
  for (auto snippet = range.first; snippet != range.second; ++snippet) {
    Diagnostics diagnostics;
    const Deck deck = parse_deck("<modules>" + snippet->second + "</modules>", tag, diagnostics);
    runs.emplace_back();
    for (const DeckNode& node : deck.root.children)
      runs.back().push_back(registry.find(node.tag)->make(node, {dimension}, diagnostics));
    EXPECT_TRUE(diagnostics.ok()) << diagnostics.error_text();
  }
  return runs;
}

void check_modules(std::vector<std::vector<PhysicsModule>>& runs, const Mesh& mesh) {
  double worst = 0;
  for (std::vector<PhysicsModule>& modules : runs) {
    Diagnostics diagnostics;
    resolve_properties(modules, diagnostics);
    connect_properties(mesh, modules, diagnostics);
    ASSERT_TRUE(diagnostics.ok()) << diagnostics.error_text();
    for (const PhysicsModule& module : modules)
      for (const auto& kernel : module.kernels) {
        ASSERT_EQ(kernel->dimension(), mesh.dimension);
        for (unsigned seed = 1; seed <= 10; ++seed)
          worst = std::max(worst, check_kernel(*kernel, mesh, seed));
      }
  }
  const std::string& tag = runs.front().front().name;
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
    auto runs = make_modules(registry, tag, snippets, 2);
    if (runs.empty())
      ADD_FAILURE() << "give it a snippet in this test";
    else
      check_modules(runs, mesh);
  }
}

TEST(Jacobian, IsTheDerivativeOfTheResidualInEveryModuleThatWorksInSpace) {
  const Mesh mesh = line_in_space();
  const ModuleRegistry registry = all_modules_there_are();
  for (const std::string& tag : registry.tags()) {
    SCOPED_TRACE("module <" + tag + ">");
    auto in_space = make_modules(registry, tag, snippets_in_space, 3);
    if (!in_space.empty()) {
      check_modules(in_space, mesh);
      continue;
    }
    for (const auto& modules : make_modules(registry, tag, snippets, 3))
      for (const PhysicsModule& module : modules)
        for (const auto& kernel : module.kernels)
          EXPECT_EQ(kernel->dimension(), 2) << "give it a snippet in space in this test";
  }
}

}  // namespace
}  // namespace hawser
