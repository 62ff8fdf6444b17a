#include "src/progress.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace hawser {
namespace {

void line(const std::string& text) {
  std::fputs((text + "\n").c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace

Progress::Progress(const Communicator& communicator, bool quiet)
    : prints_(communicator.is_root() && !quiet),
      warns_(communicator.is_root()),
      start_(std::chrono::steady_clock::now()) {}

void Progress::note(const std::string& sentence) const {
  if (prints_) line(sentence);
}

void Progress::start(const System& system, const RunDeck& deck) {
  start_ = std::chrono::steady_clock::now();
  if (!prints_) return;
  if (!deck.title.empty()) line(deck.title);
  std::vector<std::string> modules;
  for (const PhysicsModule& module : system.modules)
    modules.push_back(module.name);
  line(fmt::format("{} nodes, {} unknowns, {} rank(s); modules: {}",
                   system.mesh.vertices.global_count, system.dofs->global_count(),
                   system.mesh.communicator.size(), listed(modules)));
}

void Progress::solved(const NonlinearReport& report) {
  if (!prints_ || report.history.empty()) return;
  norms_.clear();
  for (const BlockNorm& norm : report.history.back())
    norms_ += fmt::format(" {}.{} {:.0e} {}", norm.block, norm.field, norm.residual, norm.unit);
}

void Progress::rejected(double time, double length, const std::string& why) const {
  if (warns_) line(fmt::format("step of {:g} s from t = {:g} s rejected: {}", length, time, why));
}

void Progress::stepped(const StepFigures& figures, double end) {
  if (first_time_ < 0) first_time_ = figures.time - figures.length;
  if (!prints_) return;
  const double wall = elapsed();
  const double left = wall * (end - figures.time) / (figures.time - first_time_);
  line(fmt::format(
      "step {:4d}  t {:7g} s  dt {:g} s  Newton {} linear {:3d}  residual{}  quality {:.2f}  "
      "Courant {:.2f}  wall {:.1f} s  left {:.0f} s",
      figures.step, figures.time, figures.length, figures.newton_iterations,
      figures.linear_iterations, norms_, figures.mesh_quality, figures.courant, wall, left));
}

void Progress::finish(const System& system, const RunDeck& deck, const Summary& summary,
                      const std::string& folder) const {
  if (!warns_) return;
  const auto number = [&](const char* key) { return summary.number(key).value_or(0); };
  if (prints_ && system.tow) {
    line("");
    line(fmt::format("{:<28}{:>14}{:>22}", "", "this run", "exact straight cable"));
    line(fmt::format("{:<28}{:>12.2f} m{:>20.2f} m", "end error", number("end_error_m"),
                     number("end_error_exact_m")));
    line(fmt::format("{:<28}{:>12.2f} m{:>20.2f} m", "total error (along cable)",
                     number("total_error_arc_m"), number("total_error_exact_m")));
    const std::string unit = force_unit(system.mesh);
    line(fmt::format(
        "{:<28}{:>{}.0f} {}{:>22}", unit == "N" ? "tow force" : "tow force, per m of depth",
        number(quantity_name({"tow_force", unit}).c_str()), 13 - unit.size(), unit, "-"));
  }
  if (prints_ && !system.tow)
    for (const ForceReport& force : system.forces) {
      const std::string unit = force_unit(system.mesh);
      const auto part = [&](const char* name) {
        return number(quantity_name({force.name() + name, unit}).c_str());
      };
      line(fmt::format("{}: along {:.6g} {}, across {:.6g} {}", force.name(), part("_force_along"),
                       unit, part("_force_across"), unit));
    }
  for (const ExpectDeck& expect : deck.expectations) {
    const auto got = summary.number(expect.quantity.value);
    const bool holds = got && std::abs(*got - expect.value) <= expect.within;
    if (holds && !prints_) continue;
    line(fmt::format("{}: expected {} = {:g} +- {:g} ({}); got {}{}",
                     expect.quantity.location.text(), expect.quantity.value, expect.value,
                     expect.within, expect.why,
                     got ? fmt::format("{:g}", *got) : "nothing: the run reports no such quantity",
                     holds ? ": holds" : ": FAILS"));
  }
  if (prints_) line("results: " + folder);
}

double Progress::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace hawser
