#include "src/json_log.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace hawser {
namespace {

using Json = nlohmann::ordered_json;

void tell(const Json& event) {
  const std::string text = event.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::fputs((text + "\n").c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace

void JsonLog::note(const std::string& sentence) { tell({{"event", "note"}, {"text", sentence}}); }

void JsonLog::start(const RunHeading& heading) {
  folder_ = heading.folder;
  tell({{"event", "start"},
        {"version", HAWSER_VERSION},
        {"title", heading.title},
        {"folder", heading.folder},
        {"ranks", heading.ranks},
        {"nodes", heading.nodes},
        {"unknowns", heading.unknowns},
        {"modules", heading.modules},
        {"time_s", heading.time},
        {"end_s", heading.end}});
}

void JsonLog::solved(const NonlinearReport& report) {
  newton_ = report;
  for (const std::string& sentence : report.notes)
    note(sentence);
}

void JsonLog::rejected(double time, double length, const std::string& why) {
  tell({{"event", "rejected"}, {"time_s", time}, {"step_s", length}, {"reason", why}});
}

void JsonLog::stepped(const Step& step, const MeshFigures& mesh, double end) {
  Json residuals = Json::array(), decides;
  if (!newton_.criteria.empty()) {
    const Criterion& criterion = newton_.criteria.back();
    decides = {{"block", criterion.block},
               {"field", criterion.field},
               {"test", criterion.test},
               {"value", criterion.value},
               {"tolerance", criterion.tolerance}};
  }
  if (!newton_.history.empty())
    for (const BlockNorm& norm : newton_.history.back())
      residuals.push_back({{"block", norm.block},
                           {"field", norm.field},
                           {"residual", norm.residual},
                           {"unit", norm.unit},
                           {"ratio", norm.ratio},
                           {"error", norm.error ? Json(*norm.error) : Json()}});
  tell({{"event", "step"},
        {"step", step.number},
        {"time_s", step.end.time},
        {"step_s", step.length},
        {"end_s", end},
        {"newton_iterations", step.newton_iterations},
        {"linear_iterations", step.linear_iterations},
        {"jacobians", newton_.jacobians},
        {"factorizations", newton_.factorizations},
        {"decides", decides},
        {"residuals", residuals},
        {"energy_residue_of_work_done",
         step.energy != nullptr ? Json(step.energy->residue_of_work_done()) : Json()},
        {"mesh_quality_min", mesh.least_quality},
        {"courant_max", mesh.courant}});
}

void JsonLog::wrote(const std::string& what, int step, double time) {
  tell({{"event", "output"}, {"what", what}, {"step", step}, {"time_s", time}});
}

void JsonLog::finish(const std::string& /*closing*/, const std::vector<Judgement>& /*judgements*/,
                     const Summary& summary) {
  tell({{"event", "end"}, {"folder", folder_}, {"summary", Json::parse(summary.json())}});
}

}  // namespace hawser
