#include "hawser/replay/deck_of_line.hpp"

#include <fmt/format.h>

namespace hawser {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '-':
        result += !result.empty() && result.back() == '-' ? " -" : "-";
        break;  // in a comment
      default: result += c;
    }
  return result;
}

template <class Values>
std::string joined(const Values& values) {
  std::string text;
  for (const auto& value : values)
    text += fmt::format("{}{:.15g}", text.empty() ? "" : " ", value);
  return text;
}

}  // namespace

std::vector<ReplayParameter> replay_parameters() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {
      {"ct", "1", "drag along the cable, of its wetted surface", "0.0024", true, 2e-4, 1e-5, 1},
      {"cn", "1", "drag across the cable, of diameter times length", "1.2", true, 0.05, 0.01, 100},
      {"tail_drag_area", "m^2", "of tail buoy or drogue, drag coefficient times area", "0 m^2",
       true, 0.2, 0, 1e4},
      {"current_east", "m/s", "of the water, constant", "0 m/s", true, 0.02, -5, 5},
      {"current_north", "m/s", "of the water, constant", "0 m/s", true, 0.02, -5, 5},
      {"ca", "1", "added mass across the cable, of the displaced mass", "1", false, 0.1, 0, 10},
      {"diameter", "m", "of the cable", "0.06 m", false, 1e-3, 1e-3, 10},
      {"mass", "kg/m", "of the cable, per length", "2.9 kg/m", false, 0.1, 1e-3, infinity},
      {"stiffness", "N", "EA of the cable", "1e7 N", false, 1e5, 1, infinity},
      {"density", "kg/m^3", "of the water", "1025 kg/m^3", false, 10, 1, infinity}};
}

std::string replay_deck(const MeasuredLine& line, const std::vector<ReplayParameter>& parameters,
                        const ReplayDeckOptions& options) {
  std::string given;
  for (const ReplayParameter& p : parameters)
    given += fmt::format("  <parameter name=\"{}\" value=\"{}\" unit=\"{}\" meaning=\"{}\"/>\n",
                         p.name, p.value, p.unit, p.meaning);
  return fmt::format(
      R"(<?xml version="1.0"?>
<!-- {} shots of {} receivers, {} to {}, from {} ({}); made by
       {}
     x is east, y is north, from ({:.15g}, {:.15g}) m in that file's frame; t = 0 is the first shot. The tow point
     goes where the head went (head.csv); at first the cable lies as it was measured (shape.csv). -->
<hawser title="Replay of {}">
{}  <mesh>
    <line shape="shape.csv" length="{:.15g} m" segments="{}"/>
  </mesh>
  <table name="head" file="head.csv" smooth="{:.15g} s" longest-gap="{:.15g} s"/>
  <modules>
    <cable region="cable" mass-per-length="mass" axial-stiffness="stiffness">
      <drag current="current_east; current_north" density="density" diameter="diameter" normal-coefficient="cn"
            tangential-coefficient="ct" added-mass-coefficient="ca"/>
    </cable>
    <body on="tail" mass="0 kg" drag-area="tail_drag_area" current="current_east; current_north" density="density"/>
  </modules>
  <conditions>
    <prescribe name="tow" field="displacement" on="tow-point" table="head"/>
  </conditions>
  <time scheme="bdf2" step="{:.15g} s" end="{:.15g} s"/>
  <solver>
    <linear method="mumps" tolerance="1e-8"/>
    <!-- a full step turns segments before it corrects their length: in between EA makes the residual large -->
    <newton tolerance="1e-8" line-search="false" max-iterations="40" divergence="1e14"/>
  </solver>
  <tow cable="cable" tow-point="tow-point" course="motion">
    <receivers at="{}" times="{}"/>
  </tow>
</hawser>
)",
      line.times.size(), line.receivers.size(), line.receivers.front(), line.receivers.back(),
      escaped(line.file), line.format, escaped(options.made_by), line.origin[0], line.origin[1],
      escaped(line.file), given, line.length(), options.segments, line.smooth, line.times.back(),
      options.step, line.times.back(), joined(line.arc_lengths), joined(line.times));
}

std::string head_csv(const MeasuredLine& line) {
  std::string text = "time_s,x_m,y_m\n";
  for (std::size_t i = 0; i < line.head.size(); ++i)
    text += fmt::format("{:.15g},{:.15g},{:.15g}\n", line.head_times[i], line.head[i][0],
                        line.head[i][1]);
  return text;
}

std::string shape_csv(const MeasuredLine& line) {
  std::string text = "x_m,y_m\n";
  for (const auto& place : line.shape)
    text += fmt::format("{:.15g},{:.15g}\n", place[0], place[1]);
  return text;
}

}  // namespace hawser
