#include "src/kept_case.hpp"

#include <algorithm>
#include <cstdio>

#include "hawser/deck/value.hpp"

namespace hawser {
namespace {

constexpr const char* change_prefix = "change.";
constexpr const char* end_path = "time/end";

/// Paths, or with a / at the end all that begin so.
const std::vector<std::string> may_change = {"time/end",
                                             "time/step",
                                             "time/least-step",
                                             "time/grow-after",
                                             "time/energy-growth",
                                             "time/adapt/",
                                             "solver/",
                                             "output/fields-every",
                                             "output/history-every",
                                             "output/checkpoint-every",
                                             "output/checkpoint-at-end",
                                             "title"};

bool is_free(const std::string& path) {
  // An expectation judges and does not compute; it has a key.
  if (path.compare(0, 7, "expect[") == 0 || path.compare(0, 7, "expect/") == 0) return true;
  return std::any_of(may_change.begin(), may_change.end(), [&](const std::string& known) {
    return known.back() == '/' ? path.compare(0, known.size(), known) == 0 : path == known;
  });
}

}  // namespace

std::vector<DeckChange> joined(std::vector<DeckChange> changes,
                               const std::vector<DeckChange>& later) {
  for (const DeckChange& change : later) {
    changes.erase(std::remove_if(changes.begin(), changes.end(),
                                 [&](const DeckChange& c) { return c.path == change.path; }),
                  changes.end());
    changes.push_back(change);
  }
  return changes;
}

void keep_changes(const std::vector<DeckChange>& changes, CheckpointHeader& header) {
  for (std::size_t i = 0; i < changes.size(); ++i) {
    char number[32];
    std::snprintf(number, sizeof number, "%06zu", i);
    header.texts[change_prefix + std::string(number)] = changes[i].text();
  }
}

std::vector<DeckChange> kept_changes(const CheckpointHeader& header) {
  std::vector<DeckChange> changes;
  for (const auto& [number, text] : header.part(change_prefix).texts)
    changes.push_back(read_change(text));
  return changes;
}

void check_restart(const std::vector<DeckChange>& changes, Diagnostics& diagnostics) {
  for (const DeckChange& change : changes) {
    if (is_free(change.path)) continue;
    std::vector<std::string> allowed = {"expect[...]/..."};
    for (const std::string& path : may_change)
      allowed.push_back(path + (path.back() == '/' ? "..." : ""));
    const bool is_path = change.path.find('/') != std::string::npos;
    diagnostics.error(
        {"--set " + change.text(), 0, 0},
        "a run that goes on keeps its " + std::string(is_path ? "" : "parameter ") +
            quoted(change.path) + "; allowed: " + listed(allowed) +
            ". A deck with <start from=\"checkpoint.h5\"/> begins at this state with all else "
            "of its own");
  }
}

bool sets_end(const std::vector<DeckChange>& changes) {
  return std::any_of(changes.begin(), changes.end(),
                     [](const DeckChange& change) { return change.path == end_path; });
}

void set_end(DeckNode& root, double end) {
  const Location where = {"--end", 0, 0};
  for (DeckNode& child : root.children) {
    if (child.tag != "time") continue;
    auto& all = child.attributes;
    all.erase(std::remove_if(all.begin(), all.end(),
                             [](const DeckAttribute& given) { return given.name == "end"; }),
              all.end());
    all.push_back({"end", write_value(end), where});
  }
}

std::vector<KeptFile> files_to_keep(const InputFiles::Kept& kept) {
  std::vector<KeptFile> files;
  for (const auto& [name, file] : kept)
    files.push_back({name, file.path, file.text});
  return files;
}

InputFiles::Kept kept_files(const CheckpointReader& reader) {
  InputFiles::Kept kept;
  for (KeptFile& file : reader.files())
    kept[file.name] = {std::move(file.path), std::move(file.text)};
  return kept;
}

}  // namespace hawser
