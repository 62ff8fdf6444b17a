// The tangents of a deck's kernels against differences of their residuals.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/physics/sample_cell.hpp"
#include "hawser/simulation/run.hpp"
#include "hawser/simulation/stepper.hpp"
#include "src/system.hpp"

namespace hawser {
namespace {

constexpr double tolerance = 1e-6;  // truncation and round-off of the differences
constexpr LocalIndex most_cells = 20;

struct Worst {
  TangentBlock block;
  LocalIndex cell = -1;
  std::vector<double> coordinates;  // [vertex][dimension], m
};

std::vector<double> coordinates_of(const Mesh& mesh, const Region& region, LocalIndex cell) {
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> coordinates;
  for (LocalIndex v = 0; v < region.vertices_per_cell; ++v) {
    const auto vertex = static_cast<std::size_t>(
        region.vertices[static_cast<std::size_t>(cell * region.vertices_per_cell + v)]);
    for (std::size_t j = 0; j < dimension; ++j)
      coordinates.push_back(mesh.coordinates[vertex * dimension + j]);
  }
  return coordinates;
}

/// m, between any two vertices.
double least_distance(const std::vector<double>& coordinates, std::size_t dimension) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < coordinates.size(); a += dimension)
    for (std::size_t b = 0; b < a; b += dimension) {
      double squared = 0;
      for (std::size_t j = 0; j < dimension; ++j)
        squared += std::pow(coordinates[a + j] - coordinates[b + j], 2);
      least = std::min(least, std::sqrt(squared));
    }
  return std::isfinite(least) ? least : 1;
}

/// The kernel's own amplitudes are for cells of about 1 m: places move by the size of these.
std::vector<double> amplitudes_of(const Kernel& kernel, double size) {
  std::vector<double> amplitudes = sample_amplitudes(kernel);
  for (std::size_t f = 0; f < amplitudes.size(); ++f)
    if (kernel.fields()[f].places_nodes) amplitudes[f] *= size;
  return amplitudes;
}

/// In cells spread over this rank's part of the region, each in a state of its own.
std::vector<Worst> worst_blocks(const Kernel& kernel, const Mesh& mesh, int& inadmissible) {
  const Region& region = mesh.region(kernel.domain());
  const std::size_t fields = kernel.fields().size();
  std::vector<Worst> worst(fields * fields);
  const LocalIndex stride = std::max<LocalIndex>(1, region.size() / most_cells);
  for (LocalIndex cell = 0; cell < region.size(); cell += stride) {
    const std::vector<double> coordinates = coordinates_of(mesh, region, cell);
    const double size = least_distance(coordinates, static_cast<std::size_t>(mesh.dimension));
    SampleCell sample(kernel, coordinates, static_cast<unsigned>(cell + 1),
                      amplitudes_of(kernel, size));
    const auto blocks = compare_tangent(sample);
    if (!blocks) {
      ++inadmissible;
      continue;
    }
    for (const TangentBlock& block : *blocks) {
      Worst& so_far = worst[block.row * fields + block.column];
      if (so_far.cell < 0 || block.error > so_far.block.error || std::isnan(block.error))
        so_far = {block, cell, coordinates};
    }
  }
  return worst;
}

std::string line_of(const Kernel& kernel, const Worst& worst, int dimension) {
  std::string place;
  const auto per_vertex = static_cast<std::size_t>(dimension);
  for (std::size_t j = 0; j < per_vertex; ++j) {
    double mean = 0;
    for (std::size_t v = j; v < worst.coordinates.size(); v += per_vertex)
      mean += worst.coordinates[v];
    mean /= static_cast<double>(worst.coordinates.size()) / static_cast<double>(per_vertex);
    place += fmt::format("{}{:.4g}", j == 0 ? "" : ", ", mean);
  }
  const TangentBlock& block = worst.block;
  std::string text = fmt::format("    {} by {}: {:.1e}", kernel.fields()[block.row].name,
                                 kernel.fields()[block.column].name, block.error);
  if (!(block.error <= tolerance))
    text +=
        fmt::format("  FAILS at the cell about ({}) m: the tangent has {:.6g}, differences {:.6g}",
                    place, block.tangent, block.difference);
  return text + "\n";
}

}  // namespace

TangentCheck check_tangents(const Case& run_case) {
  Stepper stepper(run_case);
  const System& system = stepper.system();
  TangentCheck check;
  for (const PhysicsModule& module : system.modules)
    for (std::size_t k = 0; k < module.kernels.size(); ++k) {
      const Kernel& kernel = *module.kernels[k];
      int inadmissible = 0;
      const std::vector<Worst> blocks = worst_blocks(kernel, system.mesh, inadmissible);
      check.text += fmt::format("{}, kernel {} of {}, on '{}'\n", named(module), k + 1,
                                module.kernels.size(), kernel.domain().text());
      for (const Worst& worst : blocks) {
        if (worst.cell < 0) continue;
        check.holds = check.holds && worst.block.error <= tolerance;
        check.text += line_of(kernel, worst, system.mesh.dimension);
      }
      if (inadmissible > 0)
        check.text += fmt::format(
            "    {} of its cells were passed over: the residual is not a number in the "
            "state that was tried\n",
            inadmissible);
    }
  const Communicator& communicator = system.mesh.communicator;
  check.holds = !communicator.any(!check.holds);
  check.text += check.holds
                    ? fmt::format("every block within {:g} of central differences\n", tolerance)
                    : "a tangent is not the derivative of its residual\n";
  return check;
}

}  // namespace hawser
