#include "src/console_log.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hawser {
namespace {

std::string text(const std::vector<BlockNorm>& norms) {
  std::string result;
  for (const BlockNorm& norm : norms)
    result += fmt::format(" {}.{} {:.0e} {}", norm.block, norm.field, norm.residual, norm.unit);
  return result;
}

}  // namespace

void ConsoleLog::note(const std::string& sentence) {
  if (tells()) terminal_.line(sentence);
}

void ConsoleLog::start(const System& system, const RunDeck& deck, const std::string& folder) {
  folder_ = folder;
  start_ = std::chrono::steady_clock::now();
  if (!tells()) return;
  if (!deck.title.empty()) terminal_.line(deck.title);
  std::vector<std::string> modules;
  for (const PhysicsModule& module : system.modules)
    modules.push_back(module.name);
  terminal_.line(fmt::format("{} nodes, {} unknowns, {} rank(s); modules: {}",
                             system.mesh.vertices.global_count, system.dofs->global_count(),
                             system.mesh.communicator.size(), listed(modules)));
}

void ConsoleLog::solved(const NonlinearReport& report) {
  if (!tells() || report.history.empty()) return;
  norms_ = text(report.history.back());
  if (detail_ != LogDetail::iterations) return;
  for (std::size_t i = 0; i < report.history.size(); ++i)
    terminal_.line(fmt::format("  iteration {:2d}{}", i, text(report.history[i])));
  terminal_.line(
      fmt::format("  {} Jacobian(s), {} factor(s)", report.jacobians, report.factorizations));
}

void ConsoleLog::rejected(double time, double length, const std::string& why) {
  terminal_.line(fmt::format("step of {:g} s from t = {:g} s rejected: {}", length, time, why),
                 Colour::warning);
}

void ConsoleLog::stepped(const StepFigures& figures, double end) {
  if (first_time_ < 0) first_time_ = figures.time - figures.length;
  if (!tells()) return;
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double left = wall * (end - figures.time) / (figures.time - first_time_);
  terminal_.line(fmt::format(
      "step {:4d}  t {:7g} s  dt {:g} s  Newton {} linear {:3d}  residual{}  quality {:.2f}  "
      "Courant {:.2f}  wall {:.1f} s  left {:.0f} s",
      figures.step, figures.time, figures.length, figures.newton_iterations,
      figures.linear_iterations, norms_, figures.mesh_quality, figures.courant, wall, left));
  terminal_.bar(std::min(1.0, figures.time / end),
                fmt::format("t {:g} of {:g} s, {:.0f} s left", figures.time, end, left));
}

void ConsoleLog::wrote(const std::string& what, int step, double time) {
  if (detail_ == LogDetail::iterations)
    terminal_.line(fmt::format("  wrote {} of step {}, t = {:g} s", what, step, time));
}

void ConsoleLog::tow_table(const Summary& summary, const std::string& unit) {
  const auto number = [&](const std::string& key) { return summary.number(key).value_or(0); };
  terminal_.line("");
  terminal_.line(fmt::format("{:<28}{:>14}{:>22}", "", "this run", "exact straight cable"));
  terminal_.line(fmt::format("{:<28}{:>12.2f} m{:>20.2f} m", "end error", number("end_error_m"),
                             number("end_error_exact_m")));
  terminal_.line(fmt::format("{:<28}{:>12.2f} m{:>20.2f} m", "total error (along cable)",
                             number("total_error_arc_m"), number("total_error_exact_m")));
  terminal_.line(fmt::format(
      "{:<28}{:>{}.0f} {}{:>22}", unit == "N" ? "tow force" : "tow force, per m of depth",
      number(quantity_name({"tow_force", unit})), 13 - unit.size(), unit, "-"));
}

void ConsoleLog::expectation(const ExpectDeck& expect, const Summary& summary) {
  const auto got = summary.number(expect.quantity.value);
  const bool holds = got && std::abs(*got - expect.value) <= expect.within;
  if (holds && !tells()) return;
  terminal_.line(
      fmt::format("{}: expected {} = {:g} +- {:g} ({}); got {}{}", expect.quantity.location.text(),
                  expect.quantity.value, expect.value, expect.within, expect.why,
                  got ? fmt::format("{:g}", *got) : "nothing: the run reports no such quantity",
                  holds ? ": holds" : ": FAILS"),
      holds ? Colour::good : Colour::bad);
}

void ConsoleLog::finish(const System& system, const RunDeck& deck, const Summary& summary) {
  const std::string unit = system.mesh.force_unit();
  if (tells() && system.tow) tow_table(summary, unit);
  if (tells() && !system.tow)
    for (const ForceReport& force : system.forces) {
      const auto part = [&](const char* name) {
        return summary.number(quantity_name({force.name() + name, unit})).value_or(0);
      };
      terminal_.line(fmt::format("{}: along {:.6g} {}, across {:.6g} {}", force.name(),
                                 part("_force_along"), unit, part("_force_across"), unit));
    }
  for (const ExpectDeck& expect : deck.expectations)
    expectation(expect, summary);
  if (tells()) terminal_.line("results: " + folder_);
}

}  // namespace hawser
