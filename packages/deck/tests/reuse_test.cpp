// Decks that extend others, values that the command line replaces, parameters.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "hawser/base/error.hpp"
#include "hawser/deck/read_deck.hpp"
#include "hawser/deck/spec.hpp"

namespace hawser {
namespace {

struct Expected {
  std::string quantity;
  double value = 0;
  static Spec<Expected> spec() {
    return Spec<Expected>("expect", "Must come out.")
        .attribute("quantity", &Expected::quantity, required(), "Which.")
        .attribute("value", &Expected::value, "as the quantity", "How much.");
  }
};

struct Prescribed {
  std::string name, on;
  Expressions value;
  static Spec<Prescribed> spec() {
    return Spec<Prescribed>("prescribe", "Prescribes.")
        .attribute("name", &Prescribed::name, "For changes.")
        .attribute("on", &Prescribed::on, required(), "Where.")
        .attribute("value", &Prescribed::value, "SI", required(), "What.");
  }
};

struct Time {
  double step = 1, end = 10;
  static Spec<Time> spec() {
    return Spec<Time>("time", "Steps.")
        .attribute("step", &Time::step, "s", positive(), "Step.")
        .attribute("end", &Time::end, "s", positive(), "End.");
  }
};

struct File {
  Located<std::string> name;
  static Spec<File> spec() {
    return Spec<File>("file", "A mesh.").attribute("name", &File::name, required(), "File.");
  }
};

struct Modules {
  std::vector<DeckNode> modules;
  static Spec<Modules> spec() {
    return Spec<Modules>("modules", "Physics.").any_children(&Modules::modules, "modules");
  }
};

struct Parameter {
  std::string name, value, unit;
  static Spec<Parameter> spec() {
    return Spec<Parameter>("parameter", "A named value.")
        .attribute("name", &Parameter::name, required(), "Name.")
        .attribute("value", &Parameter::value, required(), "Value.")
        .attribute("unit", &Parameter::unit, "Unit.");
  }
};

struct Job {
  std::string title;
  std::vector<Parameter> parameters;
  Modules modules;
  std::optional<File> file;
  std::vector<Prescribed> prescribed;
  Time time;
  std::vector<Expected> expectations;
  static Spec<Job> spec() {
    return Spec<Job>("hawser", "A run.")
        .attribute("title", &Job::title, "Title.")
        .children(&Job::parameters)
        .child(&Job::modules)
        .child(&Job::file)
        .children(&Job::prescribed)
        .child(&Job::time)
        .children(&Job::expectations);
  }
};

class Reuse : public testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) const {
    world_.on_root([&] {
      std::filesystem::create_directories(std::filesystem::path("./" + file).parent_path());
      std::ofstream(file) << text;
    });
  }
  Deck read(const std::vector<std::string>& changes = {}) {
    std::vector<DeckChange> list;
    for (const std::string& change : changes)
      list.push_back(read_change(change));
    diagnostics_ = {};
    return read_deck(world_, "case.xml", list, {Job::spec().node_spec(), {}, {}}, diagnostics_);
  }
  Job run(const std::vector<std::string>& changes = {}) {
    return Job::spec().read(read(changes).root, diagnostics_);
  }
  std::string faults(const std::vector<std::string>& changes = {}) {
    try {
      run(changes);
    } catch (const DeckError& error) {
      return std::string("thrown ") + error.what();
    }
    return diagnostics_.error_text();
  }

  Communicator world_;
  Diagnostics diagnostics_;
};

const char* base =
    "<hawser title='base'>\n"
    "  <parameter name='speed' value='2 kn'/>\n"
    "  <parameter name='angle' unit='deg' value='30'/>\n"
    "  <parameter name='across' value='speed*sin(angle)'/>\n"
    "  <modules><cable region='a' mass='1'/></modules>\n"
    "  <file name='mesh.msh'/>\n"
    "  <prescribe name='inflow' on='top' value='0; -speed'/>\n"
    "  <prescribe on='bottom' value='0 0'/>\n"
    "  <time step='2' end='20'/>\n"
    "  <expect quantity='force' value='1'/>\n"
    "  <expect quantity='error' value='2'/>\n"
    "</hawser>\n";

TEST_F(Reuse, AnElementIsMatchedByItsTagAndItsKey) {
  write("sub/base.xml", base);
  write("middle.xml",
        "<hawser extends='sub/base.xml'><time\nstep='3 min'/>"
        "<prescribe name='inflow' value='1 1'/><prescribe on='left' value='2 2'/>"
        "<modules><cable mass='5'/><cable region='b' mass='7'/></modules></hawser>");
  write("case.xml",
        "<hawser extends='middle.xml' title='case'>\n"
        "  <expect quantity='force' remove='true'/>\n"
        "  <expect quantity='drag' value='4'/>\n"
        "  <file name='other.msh'/>\n"
        "</hawser>");
  const Job deck = run();
  EXPECT_EQ(diagnostics_.error_text(), "");
  EXPECT_EQ(deck.title, "case");
  EXPECT_EQ(deck.time.step, 180);
  EXPECT_EQ(deck.time.end, 20);
  ASSERT_EQ(deck.prescribed.size(), 3u);
  EXPECT_EQ(deck.prescribed[0].on, "top");
  EXPECT_EQ(deck.prescribed[0].value[1]({}), 1);
  EXPECT_EQ(deck.prescribed[2].on, "left");
  ASSERT_EQ(deck.expectations.size(), 2u);
  EXPECT_EQ(deck.expectations[0].quantity, "error");
  EXPECT_EQ(deck.expectations[1].quantity, "drag");
  ASSERT_EQ(deck.modules.modules.size(), 2u);
  EXPECT_EQ(deck.modules.modules[0].find_attribute("mass")->value, "5");
  EXPECT_EQ(deck.modules.modules[0].find_attribute("region")->value, "a");
  EXPECT_EQ(deck.modules.modules[1].find_attribute("region")->value, "b");
  EXPECT_EQ(path_beside(read(), deck.file->name), "other.msh");
}

TEST_F(Reuse, EveryValueKeepsThePlaceWhereItWasWritten) {
  write("sub/base.xml", base);
  write("case.xml", "<hawser extends='sub/base.xml'>\n  <time step='-1'/>\n</hawser>");
  EXPECT_EQ(faults(), "case.xml:2:9: attribute 'step' of <time> is '-1': it must be > 0 s");
  write("case.xml",
        "<hawser extends='sub/base.xml'>\n  <parameter name='speed' value='0'/>\n"
        "  <time end='1/speed'/>\n  <prescribe name='x' on='y' value='spede; 0'/></hawser>");
  EXPECT_EQ(faults(),
            "case.xml:3:9: attribute 'end' of <time> is '1/speed': its value is not finite\n"
            "case.xml:4:30: attribute 'value' of <prescribe> is 'spede; 0': in 'spede', the name "
            "'spede' is not known; names are X, Y, Z, t, x, y, z, across, angle, pi, speed; did "
            "you mean 'speed'?");
  write("case.xml", "<hawser extends='sub/base.xml'/>");
  EXPECT_EQ(faults({"time/step=0.5 m"}),
            "--set time/step=0.5 m: attribute 'step' of <time> is '0.5 m': it is in m, and a value "
            "in s is needed, such as '0.5 s'");
  EXPECT_EQ(path_beside(read(), run().file->name), "sub/mesh.msh");
}

TEST_F(Reuse, TheMergedDeckNeedsNoOtherFile) {
  write("base.xml", base);
  write("case.xml", "<hawser extends='base.xml'><time step='4'/></hawser>");
  const std::string text = read({"speed=3", "expect[error]/value=speed"}).text;
  Diagnostics none;
  const Job deck = Job::spec().read(parse_deck(text, "case.xml", none).root, none);
  EXPECT_EQ(none.error_text(), "");
  EXPECT_EQ(deck.time.step, 4);
  EXPECT_EQ(deck.expectations[1].value, 3);
  // A deck that stands for itself is kept as it was written, with its comments.
  write("case.xml", std::string("<!-- why -->\n") + base);
  EXPECT_EQ(read().text, std::string("<!-- why -->\n") + base);
}

TEST_F(Reuse, ParametersAreValuesOfEveryNumberAndFormula) {
  write("case.xml", base);
  const double knot = 1852.0 / 3600;
  EXPECT_DOUBLE_EQ(run().prescribed[0].value[1]({}), -2 * knot);
  EXPECT_DOUBLE_EQ(run({"time/step=across"}).time.step, knot);
  // A bare number is in the parameter's unit.
  EXPECT_DOUBLE_EQ(run({"angle=90", "time/step=across"}).time.step, 2 * knot);
  EXPECT_EQ(run({"speed=5", "time/step=2*speed + 1"}).time.step, 11);
  EXPECT_EQ(diagnostics_.error_text(), "");
  EXPECT_EQ(
      faults({"time/step=speed"}),
      "--set time/step=speed: attribute 'step' of <time> is 'speed': the parameter 'speed' is "
      "in kn, and a value in s is needed, such as '1 s'");
  EXPECT_EQ(faults({"time/step=t"}),
            "--set time/step=t: attribute 'step' of <time> is 't': one fixed number is needed, but "
            "this depends on place or time");
  EXPECT_EQ(faults({"time/step=sped"}),
            "--set time/step=sped: attribute 'step' of <time> is 'sped': a number is needed, such "
            "as 0.5 or 1e-3, or the name of a parameter; there are speed, angle, across; did you "
            "mean 'speed'?");
}

TEST_F(Reuse, FaultyParameters) {
  const auto parameter = [&](const std::string& attributes) {
    write("case.xml",
          "<hawser>\n<parameter name='a' value='1'/>\n<parameter " + attributes + "/>\n</hawser>");
    return faults();
  };
  EXPECT_EQ(parameter("name='tow-speed' value='1'"),
            "case.xml:3:12: attribute 'name' of <parameter> is 'tow-speed': a name in formulas has "
            "letters, digits and _ only, such as tow_speed");
  EXPECT_EQ(
      parameter("name='ramp' value='1'").substr(0, 88),
      "case.xml:3:12: attribute 'name' of <parameter> is 'ramp': formulas use this name already");
  EXPECT_EQ(
      parameter("name='a' value='1'"),
      "case.xml:3:12: attribute 'name' of <parameter> is 'a': a parameter of this name stands "
      "at case.xml:2:2 already");
  EXPECT_EQ(parameter("name='b' value='2*c'"),
            "case.xml:3:21: attribute 'value' of <parameter> is '2*c': the name 'c' is not known; "
            "names are X, Y, Z, t, x, y, z, a, pi");
  EXPECT_EQ(
      parameter("name='b' unit='s' value='3 m'"),
      "case.xml:3:30: attribute 'value' of <parameter> is '3 m': it is in m, and a value in s "
      "is needed, such as '3 s'");
  EXPECT_EQ(
      parameter("name='b' unit='metre' value='3'"),
      "case.xml:3:21: attribute 'unit' of <parameter> is 'metre': there is no unit 'metre'; did "
      "you mean 'm'?");
  EXPECT_EQ(parameter("value='3'"),
            "case.xml:3:2: <parameter> needs the attribute 'name' (text): Name.");
}

TEST_F(Reuse, PathsThatLeadNowhere) {
  write("case.xml", base);
  const auto set = [&](const std::string& change) {
    const std::string text = faults({change}), start = "--set " + change + ": ";
    EXPECT_EQ(text.substr(0, start.size()), start);
    return text.substr(start.size());
  };
  EXPECT_EQ(set("sped=1"),
            "the deck has no parameter 'sped'; it has speed, angle, across; did you mean 'speed'?");
  EXPECT_EQ(set("tyme/step=1"),
            "<hawser> has no <tyme> in this deck; there are expect, file, modules, parameter, "
            "prescribe, time; did you mean 'time'?");
  EXPECT_EQ(set("time/setp=1"),
            "<time> has no attribute 'setp'; allowed: step, end; did you mean 'step'?");
  EXPECT_EQ(
      set("expect/value=1"),
      "there are 2 <expect>; say which by name or number, such as expect[1]: 'force', 'error'");
  EXPECT_EQ(set("expect[eror]/value=1"),
            "there is no <expect> 'eror'; there are 'force', 'error'; did you mean 'error'?");
  EXPECT_EQ(set("prescribe[3]/value=1 1"),
            "there is no <prescribe> '3'; there are 'inflow', one without a name");
  EXPECT_EQ(set("time/step]/a=1"),
            "the path must be like time/step or conditions/prescribe[inflow]/value");
  EXPECT_EQ(set("time[/a=1"), "a ']' is missing in the path");
  EXPECT_EQ(set("/time/step=1"), "the path must be like time/step; it has no '/' at its beginning");
  EXPECT_EQ(set("time/=1"), "the path must end with the name of an attribute, such as time/step");
  EXPECT_THROW(read_change("time"), Error);
}

TEST_F(Reuse, PathsThatLeadSomewhere) {
  write("case.xml", base);
  EXPECT_EQ(run({"title=new"}).title, "new");
  EXPECT_EQ(run({"prescribe[2]/value=3 4"}).prescribed[1].value[1]({}), 4);
  EXPECT_EQ(run({"parameter[speed]/value=4", "time/step=speed"}).time.step, 4);
  EXPECT_EQ(
      read({"modules/cable/mass=9"}).root.find_child("modules")->children[0].attributes[1].value,
      "9");
  // What the deck leaves out, with its defaults, can be set all the same.
  write("case.xml", "<hawser/>");
  EXPECT_EQ(run({"time/step=3"}).time.step, 3);
  EXPECT_EQ(diagnostics_.error_text(), "");
}

TEST_F(Reuse, FaultyExtensions) {
  write("case.xml", "<hawser\n extends='none.xml'/>");
  EXPECT_EQ(faults(), "thrown case.xml:2:2: the deck to extend cannot be read: none.xml");
  write("case.xml", "<hawser extends='b.xml'/>");
  write("b.xml", "<hawser\n extends='case.xml'/>");
  EXPECT_EQ(faults(),
            "thrown b.xml:2:2: decks extend each other in a circle: case.xml -> b.xml -> case.xml");
  write("b.xml", "<study/>");
  EXPECT_EQ(faults(), "thrown case.xml:1:9: <hawser> cannot extend b.xml, which holds <study>");
  write("b.xml", base);
  write("case.xml",
        "<hawser extends='b.xml'>\n<expect quantity='forc' remove='true'/>\n"
        "<expect remove='true'/>\n<time remove='yes'/></hawser>");
  EXPECT_EQ(
      faults(),
      "case.xml:2:2: there is no such <expect> to remove; there are 'force', 'error'\n"
      "case.xml:3:2: which <expect> is meant? There are 2: 'force', 'error'\n"
      "case.xml:4:7: attribute 'remove' of <time> is 'yes': it must be \"true\" or be left out");
}

}  // namespace
}  // namespace hawser
