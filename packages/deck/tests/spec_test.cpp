#include "hawser/deck/spec.hpp"

#include <gmock/gmock.h>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

enum class Reference { incremental, total };

struct Newton {
  int max_iterations = 10;
  double tolerance = 1e-6;
  static Spec<Newton> spec() {
    using P = Newton;
    return Spec<P>("newton", "Newton's method.")
        .attribute("max-iterations", &P::max_iterations, at_least(1), "Iterations at most.")
        .attribute("tolerance", &P::tolerance, "1", positive(), "Residual to reach.");
  }
};

struct Window {
  double begin = 0;
  std::optional<double> end;
};

struct Dirichlet : Window {
  Located<std::string> region;
  Expressions value;
  Location where;
  static Spec<Dirichlet> spec() {
    using P = Dirichlet;
    return Spec<P>("dirichlet", "Prescribes a field.")
        .attribute("region", &P::region, required(), "Where.")
        .attribute("value", &P::value, "m/s", required() && length(2), "What.")
        .attribute("begin", &P::begin, "s", "When it begins.")
        .attribute("end", &P::end, "s", "When it ends.")
        .location(&P::where)
        .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
          if (p.end && *p.end <= p.begin)
            diagnostics.error(where, "the time window ends before it begins");
        });
  }
};

struct Fluid {
  Located<std::string> region;
  double density = 1000;
  bool convection = true;
  Reference reference = Reference::total;
  std::vector<std::string> histories;
  Newton newton;
  std::optional<Newton> start;
  std::vector<Dirichlet> dirichlets;
  Fluid() { newton.max_iterations = 20; }

  static Spec<Fluid> spec() {
    using P = Fluid;
    return Spec<P>("fluid", "Flow on a moving mesh.")
        .attribute("region", &P::region, required(), "Region that the fluid fills.")
        .attribute("density", &P::density, "kg/m^3", positive(), "Mass density.")
        .attribute("convection", &P::convection, "Whether inertia convects.")
        .attribute("histories", &P::histories, "Quantities to follow.")
        .choice("reference", &P::reference,
                {{"incremental", Reference::incremental}, {"total", Reference::total}},
                "What the mesh moves from.")
        .child(&P::newton)
        .child(&P::start, Spec<Newton>("start", "Newton's method in the first step."))
        .children(&P::dirichlets, required());
  }
};

struct Modules {
  std::vector<DeckNode> modules;
  static Spec<Modules> spec() {
    return Spec<Modules>("modules", "The physics.").any_children(&Modules::modules, "modules");
  }
};

DeckNode parse(const std::string& text, Diagnostics& diagnostics) {
  return parse_deck(text, "d.xml", diagnostics).root;
}

std::string faults_of(const std::string& text) {
  Diagnostics diagnostics;
  Fluid::spec().read(parse(text, diagnostics), diagnostics);
  return diagnostics.error_text();
}

const char* good =
    "<fluid region='water' density='1025' reference='incremental' histories='drag lift'>\n"
    "  <dirichlet region='top' value='0; -0.5*ramp(t,0,10)' end='5'/>\n"
    "  <dirichlet region='side' value='0 1'/>\n"
    "  <start/>\n"
    "</fluid>\n";

TEST(Spec, FillsTheStruct) {
  Diagnostics diagnostics;
  const Fluid fluid = Fluid::spec().read(parse(good, diagnostics), diagnostics);
  diagnostics.throw_if_any();
  EXPECT_EQ(*fluid.region, "water");
  EXPECT_EQ(fluid.region.location.text(), "d.xml:1:8");
  EXPECT_EQ(fluid.density, 1025);
  EXPECT_TRUE(fluid.convection);
  EXPECT_EQ(fluid.reference, Reference::incremental);
  EXPECT_THAT(fluid.histories, testing::ElementsAre("drag", "lift"));
  EXPECT_EQ(fluid.newton.max_iterations, 20);  // the parent's default, not the child's
  EXPECT_TRUE(fluid.start.has_value());
  ASSERT_EQ(fluid.dirichlets.size(), 2u);
  EXPECT_EQ(fluid.dirichlets[0].end, 5);
  EXPECT_FALSE(fluid.dirichlets[1].end.has_value());
  EXPECT_EQ(fluid.dirichlets[1].where.text(), "d.xml:3:4");
  EXPECT_EQ(fluid.dirichlets[0].value[1].location().text(), "d.xml:2:27");
}

TEST(Spec, AllFaultsAreReportedAtOnceInTheOrderOfTheDeck) {
  EXPECT_EQ(
      faults_of("<fluid desity='1' density='0.5abc' convection='' reference='totl'\n"
                "       density='3'>\n"
                "  <newton max-iterations='0' tolerance='-1'/>\n"
                "  <newton max-iterations='3.7'/>\n"
                "  <newtn/>\n"
                "  <dirichlet region='top' value='1 2 3'/>\n"
                "  <dirichlet value='0; rmp(t,0,1)' begin='1e400'/>\n"
                "</fluid>\n"),
      "d.xml:1:2: <fluid> needs the attribute 'region' (text): Region that the fluid fills.\n"
      "d.xml:1:8: <fluid> has no attribute 'desity'; allowed: region, density, convection, "
      "histories, reference; did you mean 'density'?\n"
      "d.xml:1:19: attribute 'density' of <fluid> is '0.5abc': 'abc' after the number is not "
      "understood (in kg/m^3)\n"
      "d.xml:1:36: attribute 'convection' of <fluid> is empty; needed: true or false\n"
      "d.xml:1:50: attribute 'reference' of <fluid> is 'totl': it must be one of incremental, "
      "total; did you mean 'total'?\n"
      "d.xml:2:8: attribute 'density' of <fluid> is given twice, as '0.5abc' and as '3'; allowed: "
      "once\n"
      "d.xml:3:11: attribute 'max-iterations' of <newton> is '0': it must be >= 1\n"
      "d.xml:3:30: attribute 'tolerance' of <newton> is '-1': it must be > 0\n"
      "d.xml:4:4: <newton> stands twice in <fluid>, first at line 3; allowed: once\n"
      "d.xml:4:11: attribute 'max-iterations' of <newton> is '3.7': a whole number is needed, "
      "such as 10, without a point or exponent\n"
      "d.xml:5:4: <fluid> has no child <newtn>; allowed: <newton>, <start>, <dirichlet>; did you "
      "mean 'newton'?\n"
      "d.xml:6:27: attribute 'value' of <dirichlet> is '1 2 3': 2 values needed, 3 given\n"
      "d.xml:7:4: <dirichlet> needs the attribute 'region' (text): Where.\n"
      "d.xml:7:14: attribute 'value' of <dirichlet> is '0; rmp(t,0,1)': in 'rmp(t,0,1)', there is "
      "no function 'rmp'; functions are abs, acos, acosh, asin, asinh, atan, atan2, atanh, avg, "
      "cos, cosh, exp, ln, log, log10, log2, max, min, ramp, ramp_distance, rint, sign, sin, sinh, "
      "sqrt, sum, tan, tanh; did you mean 'ramp'?\n"
      "d.xml:7:36: attribute 'begin' of <dirichlet> is '1e400': it is too large or too small for a "
      "number of double precision (in s)");
}

TEST(Spec, FaultsOfTheWholeElement) {
  EXPECT_EQ(faults_of("<fluids/>"),
            "d.xml:1:2: <fluids> stands where <fluid> is needed; did you mean 'fluid'?");
  EXPECT_EQ(faults_of("<fluid region='a'/>"), "d.xml:1:2: <fluid> needs a child <dirichlet>");
  EXPECT_EQ(faults_of("<fluid region='a'>"
                      "<dirichlet region='b' value='0 0' begin='2' end='1'/></fluid>"),
            "d.xml:1:20: the time window ends before it begins");
  EXPECT_EQ(faults_of("<fluid region='a'><start x='1'/>"
                      "<dirichlet region='b' value='0 0'/></fluid>"),
            "d.xml:1:26: <start> has no attribute 'x'; allowed: none");
}

TEST(Spec, DiagnosticsBecomeOneDeckError) {
  Diagnostics diagnostics;
  EXPECT_NO_THROW(diagnostics.throw_if_any());
  diagnostics.error({"d.xml", 10, 1}, "second");
  diagnostics.error({"d.xml", 9, 2}, "first");
  try {
    diagnostics.throw_if_any();
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(error.what(), "d.xml:9:2: first\nd.xml:10:1: second");
  }
}

TEST(Spec, OpenChildrenAreLeftToAHigherLayer) {
  Diagnostics diagnostics;
  const DeckNode node = parse("<modules><fluid a='1'/><flud/></modules>", diagnostics);
  const Modules modules = Modules::spec().read(node, diagnostics);
  EXPECT_TRUE(diagnostics.ok());
  ASSERT_EQ(modules.modules.size(), 2u);
  EXPECT_TRUE(is_known_child(modules.modules[0], node.tag, {"fluid", "cable"}, diagnostics));
  EXPECT_FALSE(is_known_child(modules.modules[1], node.tag, {"fluid", "cable"}, diagnostics));
  EXPECT_EQ(diagnostics.error_text(),
            "d.xml:1:25: <modules> has no child <flud>; allowed: <fluid>, <cable>; did you mean "
            "'fluid'?");
}

TEST(Spec, DescribesItself) {
  EXPECT_EQ(describe(Fluid::spec().node_spec()),
            "<fluid>  Flow on a moving mesh.\n"
            "  region      text; required\n"
            "              Region that the fluid fills.\n"
            "  density     number in kg/m^3; > 0; default 1000\n"
            "              Mass density.\n"
            "  convection  true or false; default true\n"
            "              Whether inertia convects.\n"
            "  histories   list of names; optional\n"
            "              Quantities to follow.\n"
            "  reference   choice; one of incremental, total; default total\n"
            "              What the mesh moves from.\n"
            "  <newton> at most once.  Newton's method.\n"
            "    max-iterations  whole number; >= 1; default 20\n"
            "                    Iterations at most.\n"
            "    tolerance       number, no unit; > 0; default 1e-06\n"
            "                    Residual to reach.\n"
            "  <start> at most once.  Newton's method in the first step.\n"
            "  <dirichlet> at least once.  Prescribes a field.\n"
            "    region  text; required\n"
            "            Where.\n"
            "    value   list of expressions in m/s; 2 values; required\n"
            "            What.\n"
            "    begin   number in s; default 0\n"
            "            When it begins.\n"
            "    end     number in s; optional\n"
            "            When it ends.\n");
}

TEST(Spec, TheResolvedDeckHoldsEveryDefaultAndReadsBackTheSame) {
  Diagnostics diagnostics;
  const DeckLanguage spec{Fluid::spec().node_spec()};
  const std::string resolved = resolved_deck(parse(good, diagnostics), spec);
  EXPECT_EQ(resolved,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<fluid region=\"water\" density=\"1025\" convection=\"true\" histories=\"drag lift\" "
            "reference=\"incremental\">\n"
            "  <dirichlet region=\"top\" value=\"0; -0.5*ramp(t,0,10)\" begin=\"0\" end=\"5\"/>\n"
            "  <dirichlet region=\"side\" value=\"0 1\" begin=\"0\"/>\n"
            "  <start/>\n"
            "  <newton max-iterations=\"20\" tolerance=\"1e-06\"/>\n"
            "</fluid>\n");
  EXPECT_EQ(resolved_deck(parse(resolved, diagnostics), spec), resolved);
  Fluid::spec().read(parse(resolved, diagnostics), diagnostics);
  EXPECT_EQ(diagnostics.error_text(), "");
}

TEST(Spec, TheResolvedDeckFindsTheSpecsOfOpenChildren) {
  Diagnostics diagnostics;
  const DeckLanguage language{Modules::spec().node_spec(),
                              {{"modules", {Newton::spec().node_spec()}}}};
  const DeckNode node = parse(
      "<modules><newton tolerance=' 1 '/><other a='&lt;&amp;&quot;'/></modules>", diagnostics);
  EXPECT_EQ(resolved_deck(node, language),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<modules>\n"
            "  <newton max-iterations=\"10\" tolerance=\"1\"/>\n"
            "  <other a=\"&lt;&amp;&quot;\"/>\n"
            "</modules>\n");
}

}  // namespace
}  // namespace hawser
