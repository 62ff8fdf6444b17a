#include "hawser/study/study.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/deck/deck.hpp"
#include "src/jobs.hpp"
#include "src/study_record.hpp"

namespace hawser {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The summary is written last, and a run that begins anew removes it first: where it is, the
/// resolved deck beside it is the one that was run.
bool is_finished(const fs::path& folder, const StudyCase& one) {
  return fs::exists(folder / "summary.json") && text_of(folder / "resolved.xml") == one.resolved;
}

/// The last line that a run said; where it does not end well that is why.
std::string last_line(const fs::path& log) {
  std::istringstream text(text_of(log));
  std::string last;
  for (std::string line; std::getline(text, line);)
    if (!trimmed(line).empty()) last = trimmed(line);
  return last;
}

class StudyRun {
 public:
  StudyRun(const StudyOptions& options, StudyDeck study, std::vector<StudyCase> cases)
      : options_(options),
        study_(std::move(study)),
        cases_(std::move(cases)),
        states_(cases_.size()),
        at_a_time_(options.jobs > 0 ? options.jobs : std::max(1, processors() / study_.ranks)) {}

  StudyResult run() {
    keep_finished();
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (!states_[i].kept) {
        jobs.push_back(job(cases_[i]));
        case_of_job_.push_back(i);
      }
    say(std::to_string(cases_.size()) + " cases, " + std::to_string(cases_.size() - jobs.size()) +
        " of them finished before; " + std::to_string(at_a_time_) + " at a time on " +
        std::to_string(study_.ranks) + (study_.ranks == 1 ? " rank" : " ranks") + " each");
    write();
    Jobs runner;
    runner.run(
        jobs, at_a_time_,
        [&](std::size_t place) { states_[case_of_job_[place]].kind = CaseState::Kind::running; },
        [&](std::size_t place, const JobResult& result) { ended(case_of_job_[place], result); });
    write();
    return count();
  }

 private:
  fs::path folder(const StudyCase& one) const { return fs::path(options_.output) / one.folder(); }
  std::string record() const { return (fs::path(options_.output) / "study.json").string(); }
  void write() const { write_study(record(), study_, options_.file, cases_, states_); }
  void say(const std::string& line) const {
    if (options_.quiet) return;
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
  }

  void keep_finished() {
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      if (options_.fresh || !is_finished(folder(cases_[i]), cases_[i])) continue;
      states_[i].kept = true;
      take_summary(i);
    }
    recall_times(record(), cases_, states_);
  }

  Job job(const StudyCase& one) const {
    std::error_code error;
    fs::create_directories(folder(one), error);
    if (error)
      throw OutputError("cannot make the folder " + folder(one).string() + ": " + error.message());
    std::vector<std::string> command;
    if (study_.ranks > 1)
      command = {"mpirun", "-np", std::to_string(study_.ranks), "--bind-to", "none"};
    command.insert(command.end(), {options_.program, "run", one.deck, "--output",
                                   folder(one).string(), "--force"});
    for (const auto& [path, value] : one.values)
      command.insert(command.end(), {"--set", path + "=" + value});
    command.insert(command.end(), options_.run_arguments.begin(), options_.run_arguments.end());
    return {command, (folder(one) / "log.txt").string()};
  }

  /// A run whose expectations do not all hold is finished too; the report shows which.
  void take_summary(std::size_t i) {
    const auto summary =
        nlohmann::json::parse(text_of(folder(cases_[i]) / "summary.json"), nullptr, false);
    const bool fails = summary.is_object() && summary.value("expectations_failed", 0) > 0;
    states_[i].kind = CaseState::Kind::finished;
    states_[i].exit_code = static_cast<int>(fails ? ExitCode::expectation : ExitCode::done);
  }

  void ended(std::size_t i, const JobResult& result) {
    CaseState& state = states_[i];
    state.exit_code = result.exit_code;
    state.wall = result.wall;
    state.cpu = result.cpu;
    state.kind = CaseState::Kind::failed;
    if (is_finished(folder(cases_[i]), cases_[i]))
      take_summary(i);
    else if (Jobs::interrupted())
      state.kind = CaseState::Kind::stopped;
    else if (result.exit_code == static_cast<int>(ExitCode::done))
      state.reason = "a deck was changed while the study ran; start it again";
    else
      state.reason = last_line(folder(cases_[i]) / "log.txt");
    write();
    report(i);
  }

  void report(std::size_t i) {
    const CaseState& state = states_[i];
    std::size_t open = 0, done = 0;
    double spent = 0;
    for (const CaseState& one : states_) {
      const bool is_open =
          one.kind == CaseState::Kind::waiting || one.kind == CaseState::Kind::running;
      open += is_open ? 1 : 0;
      if (!is_open && !one.kept) ++done, spent += one.wall;
    }
    std::ostringstream line;
    line << "[" << cases_.size() - open << "/" << cases_.size() << "] " << cases_[i].folder()
         << " (" << cases_[i].title << "): ";
    if (state.kind == CaseState::Kind::finished)
      line << "done" << (state.exit_code == 0 ? "" : ", an expectation does not hold");
    else if (state.kind == CaseState::Kind::stopped)
      line << "stopped";
    else
      line << "FAILED, exit code " << state.exit_code << ": " << state.reason;
    line << "; " << std::lround(state.wall) << " s";
    if (open > 0 && done > 0 && !Jobs::interrupted()) {
      const double each = spent / static_cast<double>(done);
      line << ", about " << std::lround(each * static_cast<double>(open) / at_a_time_)
           << " s to go";
    }
    say(line.str());
  }

  StudyResult count() const {
    StudyResult result;
    for (const CaseState& state : states_) {
      result.finished += state.kind == CaseState::Kind::finished ? 1 : 0;
      result.kept += state.kept ? 1 : 0;
      result.failed += state.kind == CaseState::Kind::failed ? 1 : 0;
      result.waiting +=
          state.kind == CaseState::Kind::waiting || state.kind == CaseState::Kind::stopped ? 1 : 0;
    }
    return result;
  }

  const StudyOptions& options_;
  StudyDeck study_;
  std::vector<StudyCase> cases_;
  std::vector<CaseState> states_;
  int at_a_time_;
  std::vector<std::size_t> case_of_job_;
};

}  // namespace

CheckedStudy read_study(const Communicator& communicator, const std::string& file,
                        const ResolveDeck& resolve) {
  Diagnostics diagnostics;
  const Deck deck = read_deck(communicator, file, diagnostics);
  CheckedStudy result{StudyDeck::spec().read(deck.root, diagnostics), {}};
  diagnostics.throw_if_any();
  result.cases = expand(result.study, file, resolve, diagnostics);
  diagnostics.throw_if_any();
  return result;
}

StudyResult run_study(const StudyOptions& options, const ResolveDeck& resolve) {
  // MPI is not started here; see Communicator.
  CheckedStudy found = read_study(Communicator(MPI_COMM_NULL), options.file, resolve);
  return StudyRun(options, std::move(found.study), std::move(found.cases)).run();
}

}  // namespace hawser
