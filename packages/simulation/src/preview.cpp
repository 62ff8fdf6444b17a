#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "hawser/report/mesh_monitor.hpp"
#include "hawser/simulation/run.hpp"
#include "hawser/simulation/run_deck.hpp"
#include "hawser/simulation/stepper.hpp"
#include "src/system.hpp"

namespace hawser {
namespace {

constexpr double megabyte = 1 << 20;

std::string unknowns(const DofMap& dofs) {
  std::vector<long long> count(dofs.fields().size(), 0);
  for (LocalIndex row = 0; row < dofs.owned(); ++row)
    ++count[static_cast<std::size_t>(dofs.info(row).field)];
  std::string text;
  for (std::size_t f = 0; f < count.size(); ++f)
    text += fmt::format("{}{} {}", f == 0 ? "" : ", ", dofs.fields()[f].name,
                        dofs.mesh().communicator.sum(count[f]));
  return text;
}

/// Most memory that this process has had so far, in bytes.
double resident() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

/// Bytes of a factor with `entries` in the matrix. MUMPS: nested dissection in the plane, 31/4 n
/// log2 n entries per triangle of the factor for n nodes (George 1973), each a block of the
/// unknowns that meet at a node. Incomplete: each level of fill adds about the matrix once.
double factor_bytes(const LinearOptions& options, double entries, double rows, double nodes) {
  constexpr double entry = sizeof(double) + sizeof(LocalIndex);
  if (options.method == LinearOptions::Method::gmres)
    return entry * entries * (1 + options.fill_level);
  const double block = rows / nodes;
  return sizeof(double) * 2 * 31.0 / 4 * nodes * std::log2(std::max(nodes, 2.0)) * block * block;
}

struct Quality {
  double least = 1, mean = 0;
  long long triangles = 0;
  std::string text() const {
    return fmt::format("{} triangles, quality least {:.3f}, mean {:.3f} (1 is equilateral)",
                       triangles, least, mean);
  }
};

Quality quality_of(const Mesh& mesh) {
  Quality quality;
  double sum = 0;
  for (std::size_t cell = 0; cell < mesh.body.cell_ids.size(); ++cell) {
    if (mesh.body.cell_owners[cell] != mesh.communicator.rank()) continue;
    const double* corner[3];
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = &mesh.coordinates[static_cast<std::size_t>(mesh.body.vertices[3 * cell + k]) *
                                    static_cast<std::size_t>(mesh.dimension)];
    const double q = triangle_quality(corner[0], corner[1], corner[2]);
    quality.least = std::min(quality.least, q);
    sum += q;
    ++quality.triangles;
  }
  quality.least = mesh.communicator.min(quality.least);
  quality.triangles = mesh.communicator.sum(quality.triangles);
  quality.mean = mesh.communicator.sum(sum) / static_cast<double>(std::max(1LL, quality.triangles));
  return quality;
}

std::string notes_of(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& sentence : notes)
    text += "note        " + sentence + "\n";
  return text;
}

}  // namespace

std::string check_with_mesh(const Case& run_case) { return notes_of(Stepper(run_case).notes()); }

std::string preview(const Case& run_case) {
  Stepper stepper(run_case);
  System& system = stepper.system();
  const RunDeck& deck = run_case.deck();
  const double length = deck.time.step;
  const Communicator& communicator = system.mesh.communicator;
  system.problem->begin_step(length);
  const double courant = inspect_mesh(*system.dofs, system.problem->state()).courant;
  const double nodes = static_cast<double>(system.mesh.vertices.global_count);
  const double rows = static_cast<double>(system.dofs->global_count());
  const double entries = system.problem->system().entries();
  const double factor = factor_bytes(deck.solver.linear, entries, rows, nodes);
  const double vectors = sizeof(double) * rows * deck.solver.linear.restart;
  const double now = communicator.sum(resident());
  std::string text =
      fmt::format("unknowns    {}: {} in all, on {} nodes\n", unknowns(*system.dofs), rows, nodes);
  const Quality quality = quality_of(system.mesh);
  if (quality.triangles > 0) text += "mesh        " + quality.text() + "\n";
  const double steps = std::ceil(deck.time.end / deck.time.step - 1e-6);
  if (!deck.time.steady())
    text += fmt::format(
        "first step  {:g} s, Courant number up to {:.3g}; at least {:.15g} step{} to t = {:g} s\n",
        length, courant, steps, steps == 1 ? "" : "s", deck.time.end);
  text += fmt::format(
      "memory      about {:.0f} MB on {} rank(s): {:.0f} now, with a matrix of {} entries; factor "
      "about {:.0f}, vectors {:.0f}\n",
      (now + factor + vectors) / megabyte, communicator.size(), now / megabyte, entries,
      factor / megabyte, vectors / megabyte);
  return text + notes_of(stepper.notes());
}

std::string make_mesh(const Case& run_case, const std::string& file) {
  const Mesh mesh = read_mesh(run_case, provide_mesh(run_case, file).file);
  const Quality quality = quality_of(mesh);
  std::string text = fmt::format("{} nodes", mesh.vertices.global_count);
  if (quality.triangles > 0) text += ", " + quality.text();
  text += "\n";
  for (const Region& region : mesh.regions) {
    long long cells = 0;
    for (const int owner : region.cell_owners)
      cells += owner == mesh.communicator.rank() ? 1 : 0;
    cells = mesh.communicator.sum(cells);
    const char* const kind = region.shape == CellShape::point  ? "point"
                             : region.shape == CellShape::line ? "segment"
                                                               : "cell";
    text += fmt::format("  {:<16} {} {}{}\n", region.name, cells, kind, cells == 1 ? "" : "s");
  }
  return text + notes_of(mesh.notes);
}

}  // namespace hawser
