// Decks that extend others, and values that the command line replaces.
#include "deck_reading.hpp"

namespace hawser {
namespace {

TEST_F(DeckReading, AnElementIsMatchedByItsTagAndItsKey) {
  write("sub/base.xml", base_deck);
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

TEST_F(DeckReading, EveryValueKeepsThePlaceWhereItWasWritten) {
  write("sub/base.xml", base_deck);
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

TEST_F(DeckReading, TheMergedDeckNeedsNoOtherFile) {
  write("base.xml", base_deck);
  write("case.xml", "<hawser extends='base.xml'><time step='4'/></hawser>");
  const std::string text = read({"speed=3", "expect[error]/value=speed"}).text;
  Diagnostics none;
  const Job deck = Job::spec().read(parse_deck(text, "case.xml", none).root, none);
  EXPECT_EQ(none.error_text(), "");
  EXPECT_EQ(deck.time.step, 4);
  EXPECT_EQ(deck.expectations[1].value, 3);
  // A deck that stands for itself is kept as it was written, with its comments.
  write("case.xml", std::string("<!-- why -->\n") + base_deck);
  EXPECT_EQ(read().text, std::string("<!-- why -->\n") + base_deck);
}

TEST_F(DeckReading, PathsThatLeadNowhere) {
  write("case.xml", base_deck);
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

TEST_F(DeckReading, PathsThatLeadSomewhere) {
  write("case.xml", base_deck);
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

// A change without a value takes away what is at its path.
TEST_F(DeckReading, ChangesThatTakeAway) {
  write("case.xml", base_deck);
  EXPECT_EQ(run({"time/step="}).time.step, 1) << "the default";
  EXPECT_EQ(run({"title="}).title, "");
  EXPECT_EQ(run({"prescribe[inflow]/name="}).prescribed[0].name, "");
  EXPECT_EQ(run({"expect[error]="}).expectations.size(), 1U);
  EXPECT_EQ(run({"expect[1]="}).expectations[0].quantity, "error");
  EXPECT_EQ(run({"expect[force]=", "expect="}).expectations.size(), 0U);
  EXPECT_EQ(run({"prescribe[2]="}).prescribed.size(), 1U);
  EXPECT_EQ(run({"time="}).time.end, 10);
  EXPECT_FALSE(run({"file="}).file);
  EXPECT_TRUE(run({"modules/cable="}).modules.modules.empty());
  EXPECT_EQ(diagnostics_.error_text(), "");
  const auto said = [&](const std::string& change) {
    const std::string text = faults({change}), start = "--set " + change + ": ";
    EXPECT_EQ(text.substr(0, start.size()), start);
    return text.substr(start.size());
  };
  EXPECT_EQ(
      said("time/stpe="),
      "<time> has no 'stpe' that could be taken away; it has step, end; did you mean 'step'?");
  EXPECT_EQ(said("expect[eror]="),
            "there is no <expect> 'eror'; there are 'force', 'error'; did you mean 'error'?");
  EXPECT_EQ(
      said("expect="),
      "there are 2 <expect>; say which by name or number, such as expect[1]: 'force', 'error'");
  EXPECT_EQ(said("time[="), "a ']' is missing in the path");
  // What is required is missed as ever.
  EXPECT_NE(faults({"prescribe[inflow]/on="}).find("<prescribe> needs the attribute 'on'"),
            std::string::npos);
}

TEST_F(DeckReading, FaultyExtensions) {
  write("case.xml", "<hawser\n extends='none.xml'/>");
  EXPECT_EQ(faults(), "thrown case.xml:2:2: the deck to extend cannot be read: none.xml");
  write("case.xml", "<hawser extends='b.xml'/>");
  write("b.xml", "<hawser\n extends='case.xml'/>");
  EXPECT_EQ(faults(),
            "thrown b.xml:2:2: decks extend each other in a circle: case.xml -> b.xml -> case.xml");
  write("b.xml", "<study/>");
  EXPECT_EQ(faults(), "thrown case.xml:1:9: <hawser> cannot extend b.xml, which holds <study>");
  write("b.xml", base_deck);
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
