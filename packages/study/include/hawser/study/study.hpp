#pragma once
// Runs a study's cases as processes of their own, side by side. This process must not have started
// MPI: its children would take themselves for ranks of it.
#include "hawser/study/cases.hpp"

namespace hawser {

struct StudyOptions {
  std::string file;                        ///< the study
  std::string output;                      ///< folder for the results
  std::string program;                     ///< that runs a deck
  std::vector<std::string> run_arguments;  ///< further ones for every run
  int jobs = 0;        ///< runs at a time; 0: as many as there are processors for
  bool fresh = false;  ///< run finished cases again
  bool quiet = false;  ///< no lines of progress
};

/// What became of a study.
struct StudyResult {
  int finished = 0, kept = 0, failed = 0, waiting = 0;
};

struct CheckedStudy {
  StudyDeck study;
  std::vector<StudyCase> cases;
};
/// The study in `file` and all of its cases, each resolved. Collective; DeckError with every fault.
CheckedStudy read_study(const Communicator& communicator, const std::string& file,
                        const ResolveDeck& resolve);

/// A case is not run again when its folder holds the summary.json of the very deck. One that fails
/// does not stop the others. Throws DeckError with every fault before anything runs, or
/// OutputError.
StudyResult run_study(const StudyOptions& options, const ResolveDeck& resolve);

}  // namespace hawser
