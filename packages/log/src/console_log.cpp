#include "src/console_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace hawser {
namespace {

std::string text(const Criterion& decides) {
  if (decides.value == 0) return "nothing: all at round-off";
  return fmt::format("{}.{} {} {:.1e} of {:.0e}", decides.block, decides.field, decides.test,
                     decides.value, decides.tolerance);
}

std::string text(const BlockNorm& norm) {
  return fmt::format("    {:24} residual {:.1e} {:6} ratio {:.1e}{}", norm.block + "." + norm.field,
                     norm.residual, norm.unit, norm.ratio,
                     norm.error ? fmt::format("  error {:.1e}", *norm.error) : "");
}

}  // namespace

void ConsoleLog::note(const std::string& sentence) {
  if (tells()) terminal_.line(sentence);
}

void ConsoleLog::warn(const std::string& sentence) { terminal_.line(sentence, Colour::warning); }

void ConsoleLog::start(const RunHeading& heading) {
  folder_ = heading.folder;
  start_ = std::chrono::steady_clock::now();
  if (!tells()) return;
  if (!heading.title.empty()) terminal_.line(heading.title);
  terminal_.line(fmt::format("{} nodes, {} unknowns, {} rank(s); modules: {}", heading.nodes,
                             heading.unknowns, heading.ranks, listed(heading.modules)));
}

void ConsoleLog::solved(const NonlinearReport& report) {
  if (tells())
    for (const std::string& sentence : report.notes)
      terminal_.line(sentence);
  if (!tells() || report.criteria.empty()) return;
  decides_ = text(report.criteria.back());
  if (detail_ != LogDetail::iterations) return;
  for (std::size_t i = 0; i < report.history.size(); ++i) {
    terminal_.line(fmt::format("  iteration {:2d}  decides {}", i, text(report.criteria[i])));
    for (const BlockNorm& norm : report.history[i])
      terminal_.line(text(norm));
  }
  terminal_.line(
      fmt::format("  {} Jacobian(s), {} factor(s)", report.jacobians, report.factorizations));
}

void ConsoleLog::rejected(double time, double length, const std::string& why) {
  terminal_.line(fmt::format("step of {:g} s from t = {:g} s rejected: {}", length, time, why),
                 Colour::warning);
}

void ConsoleLog::stepped(const Step& step, const MeshFigures& mesh, double end) {
  const double time = step.end.time;
  if (first_time_ < 0) first_time_ = time - step.length;
  if (!tells()) return;
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  // The last step ends at `end` to round-off; there is no -0 s.
  const double left = std::max(0.0, wall * (end - time) / (time - first_time_));
  terminal_.line(fmt::format(
      "step {:4d}  t {:7g} s  dt {:g} s  Newton {} linear {:3d}  decides {}  quality {:.2f}  "
      "Courant {:.2f}{}  wall {:.1f} s  left {:.0f} s",
      step.number, time, step.length, step.newton_iterations, step.linear_iterations, decides_,
      mesh.least_quality, mesh.courant,
      step.energy != nullptr
          ? fmt::format("  energy off by {:.0e} of the work", step.energy->residue_of_work_done())
          : "",
      wall, left));
  terminal_.bar(std::min(1.0, time / end),
                fmt::format("t {:g} of {:g} s, {:.0f} s left", time, end, left));
}

void ConsoleLog::wrote(const std::string& what, int step, double time) {
  if (detail_ == LogDetail::iterations)
    terminal_.line(fmt::format("  wrote {} of step {}, t = {:g} s", what, step, time));
}

void ConsoleLog::tell(const Judgement& judgement) {
  const auto& [expect, got, holds] = judgement;
  if (holds && !tells()) return;
  terminal_.line(
      fmt::format("{}: expected {} = {:g} +- {:g} ({}); got {}{}", expect.quantity.location.text(),
                  expect.quantity.value, expect.value, expect.within, expect.why,
                  got ? fmt::format("{:g}", *got) : "nothing: the run reports no such quantity",
                  holds ? ": holds" : ": FAILS"),
      holds ? Colour::good : Colour::bad);
}

void ConsoleLog::finish(const std::string& closing, const std::vector<Judgement>& judgements,
                        const Summary& /*summary*/) {
  std::istringstream lines(closing);
  for (std::string line; tells() && std::getline(lines, line);)
    terminal_.line(line);
  for (const Judgement& judgement : judgements)
    tell(judgement);
  if (tells()) terminal_.line("results: " + folder_);
}

}  // namespace hawser
