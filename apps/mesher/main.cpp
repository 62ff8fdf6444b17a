// hawser_mesher: makes the mesh of a box of water, with or without a cable in it, or of a geometry
// in gmsh's language.
//
// A separate program, and the only part of Hawser that links gmsh: gmsh is under the GPL, and so is
// this program as built. Hawser itself (BSD-3-Clause) only reads the file that it writes.
//
//   hawser_mesher --box -4369.35 -5500 4369.35 4348.6 --cable 0 0 0 -420
//       --cable-size 10 --far-size 500 --growth .15 --output tow.msh
//   hawser_mesher --box 0 0 1 1 --no-cable --structured 8 8 --flow-direction=+x --output square.msh
//   hawser_mesher --geo flag.geo --number size .02 --output flag.msh
//
// Physical groups of a box: the surface "water"; the lines "inflow" and "outflow" (across the
// flow), "sides" (along it), "left", "right", "bottom", "top" (the same lines by place), "cable";
// the points "corner" (xmin, ymin), "tow-point" and "tail" (the cable's start and end).
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "box_mesh.hpp"
#include "geo_mesh.hpp"
#include "hawser/base/error.hpp"

namespace {

using hawser::mesher::BoxOptions;

template <std::size_t n>
void set(std::array<double, n>& to, const std::vector<double>& from) {
  std::copy(from.begin(), from.end(), to.begin());
}

int exit_code(hawser::ExitCode code) { return static_cast<int>(code); }

}  // namespace

int main(int argc, char** argv) {
  BoxOptions options;
  hawser::mesher::GeoOptions geo;
  std::vector<double> box, cable;
  std::vector<int> structured;
  CLI::App app{
      "Meshes a box of water, with or without a cable in it, or a .geo file (lengths in m)."};
  auto* of_geo = app.add_option("--geo", geo.file, "a geometry in gmsh's language, in the plane");
  app.add_option("--number", geo.numbers, "name and value of a constant of the geometry")
      ->needs(of_geo);
  auto* of_box = app.add_option("--box", box, "xmin ymin xmax ymax")->expected(4)->excludes(of_geo);
  auto* with = app.add_option("--cable", cable, "x0 y0 x1 y1: tow point, tail")->expected(4);
  auto* without = app.add_flag("--no-cable", "water only")->excludes(with);
  app.add_option("--cable-size", options.cable_size, "segment length on the cable");
  app.add_option("--far-size", options.far_size,
                 "largest size; the size everywhere without a cable");
  app.add_option("--growth", options.growth, "of the size per distance from the cable")
      ->capture_default_str();
  app.add_option("--end-size", options.end_size, "segment length at the cable's ends");
  app.add_option("--structured", structured, "cells in x and y: a grid of right triangles")
      ->expected(2);
  app.add_option("--refinements", options.refinements, "how often all triangles are quartered");
  app.add_option("--flow-direction", options.flow_direction, "where the water flows")
      ->capture_default_str()
      ->check(CLI::IsMember({"-y", "+y", "-x", "+x"}));
  app.add_option("--output", options.output, "the file to write (MSH 4.1)")->required();
  try {
    app.parse(argc, argv);
    if (of_geo->empty() && of_box->empty()) throw CLI::RequiredError("--box or --geo");
    if (of_geo->empty() && with->empty() && without->empty())
      throw CLI::RequiredError("--cable or --no-cable");
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    std::fprintf(stderr, "hawser_mesher: %s\n", error.what());
    return exit_code(hawser::ExitCode::usage);
  }

  set(options.box, box);
  if (!cable.empty()) set(options.cable.emplace(), cable);
  if (!structured.empty()) options.structured = {structured[0], structured[1]};
  try {
    if (of_geo->empty()) check(options);
    geo.refinements = options.refinements;
    geo.output = options.output;
    const auto summary = of_geo->empty() ? mesh_box(options) : mesh_geo(geo);
    std::printf("%zu nodes, %zu triangles, %zu cable segments, quality least %.3f mean %.3f\n",
                summary.nodes, summary.triangles, summary.segments, summary.least_quality,
                summary.mean_quality);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hawser_mesher: %s\n", error.what());
    return exit_code(hawser::ExitCode::mesh);
  }
  return exit_code(hawser::ExitCode::done);
}
