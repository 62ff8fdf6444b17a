#pragma once
// study.json: what a study consists of and how far it is. The report is made from it.
#include <string>
#include <vector>

#include "hawser/study/cases.hpp"

namespace hawser {

struct CaseState {
  enum class Kind { waiting, running, finished, failed, stopped };
  Kind kind = Kind::waiting;
  int exit_code = 0;
  std::string reason;        ///< of a failure, one line
  bool kept = false;         ///< finished by an earlier call
  double wall = 0, cpu = 0;  ///< s
};

/// All or nothing; OutputError.
void write_study(const std::string& path, const StudyDeck& study, const std::string& deck_file,
                 const std::vector<StudyCase>& cases, const std::vector<CaseState>& states);

/// Wall and CPU seconds of cases that an earlier call finished, by folder; where there are any.
void recall_times(const std::string& path, const std::vector<StudyCase>& cases,
                  std::vector<CaseState>& states);

}  // namespace hawser
