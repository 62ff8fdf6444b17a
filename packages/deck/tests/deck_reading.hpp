#pragma once
// A small language of decks, and decks written and read by tests.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "hawser/base/error.hpp"
#include "hawser/deck/read_deck.hpp"
#include "hawser/deck/spec.hpp"

namespace hawser {

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

class DeckReading : public testing::Test {
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
    return read_deck(world_, "case.xml", list, {Job::spec().node_spec()}, diagnostics_);
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

constexpr const char* base_deck =
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

}  // namespace hawser
