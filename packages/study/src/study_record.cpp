#include "src/study_record.hpp"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

using Json = nlohmann::ordered_json;

const char* word(CaseState::Kind kind) {
  switch (kind) {
    case CaseState::Kind::running: return "running";
    case CaseState::Kind::finished: return "finished";
    case CaseState::Kind::failed: return "failed";
    case CaseState::Kind::stopped: return "stopped";
    default: return "waiting";
  }
}

}  // namespace

void write_study(const std::string& path, const StudyDeck& study, const std::string& deck_file,
                 const std::vector<StudyCase>& cases, const std::vector<CaseState>& states) {
  Json root = {{"title", study.title}, {"study", deck_file}, {"report", study.report}};
  Json& sweeps = root["sweeps"] = Json::array();
  for (const SweepDeck& sweep : study.sweeps) {
    Json varied = Json::array();
    for (const VaryDeck& vary : sweep.varies)
      varied.push_back(vary.path.value);
    sweeps.push_back({{"name", sweep.name.value},
                      {"deck", sweep.deck.value},
                      {"meaning", sweep.meaning},
                      {"varied", varied},
                      {"cases", Json::array()}});
  }
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const StudyCase& one = cases[i];
    const CaseState& state = states[i];
    Json values = Json::object();
    for (const auto& [name, value] : one.values)
      values[name] = value;
    Json entry = {
        {"name", one.name},       {"title", one.title},        {"folder", one.folder()},
        {"values", values},       {"state", word(state.kind)}, {"exit_code", state.exit_code},
        {"reason", state.reason}, {"wall_s", state.wall},      {"cpu_s", state.cpu}};
    for (Json& sweep : sweeps)
      if (sweep["name"] == one.sweep) sweep["cases"].push_back(entry);
  }
  const std::string partial = path + ".partial";
  std::ofstream file(partial);
  file << root.dump(1) << "\n";
  file.close();
  if (!file || std::rename(partial.c_str(), path.c_str()) != 0)
    throw OutputError("cannot write " + path + ": " + std::strerror(errno));
}

void recall_times(const std::string& path, const std::vector<StudyCase>& cases,
                  std::vector<CaseState>& states) {
  std::ifstream file(path);
  const Json root = Json::parse(file, nullptr, false);
  if (root.is_discarded() || !root.contains("sweeps")) return;
  for (const Json& sweep : root["sweeps"])
    for (const Json& entry : sweep["cases"])
      for (std::size_t i = 0; i < cases.size(); ++i)
        if (states[i].kept && cases[i].folder() == entry["folder"]) {
          states[i].wall = entry["wall_s"];
          states[i].cpu = entry["cpu_s"];
        }
}

}  // namespace hawser
