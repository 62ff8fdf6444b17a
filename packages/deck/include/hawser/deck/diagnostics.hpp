#pragma once
// Collects every fault of a deck, so that a user mends them all in one go, and what he may not
// expect.
//
// All ranks read the same text, so all ranks collect the same faults: nothing here communicates,
// and what is reported must not depend on the rank.
#include <string>
#include <vector>

#include "hawser/deck/location.hpp"

namespace hawser {

class Diagnostics {
 public:
  void error(const Location& where, const std::string& sentence);
  /// No fault, but worth a look: told in the run's head.
  void note(const Location& where, const std::string& sentence);

  std::size_t error_count() const { return errors_.size(); }
  bool ok() const { return errors_.empty(); }

  std::string error_text() const;  ///< one line "file:line:column: sentence" per fault, by place
  void throw_if_any() const;       ///< one DeckError with error_text(), if there are errors
  std::vector<std::string> notes() const;  ///< "file:line:column: sentence", by place

 private:
  struct Entry {
    Location where;
    std::string sentence;
  };
  static void add(std::vector<Entry>& entries, const Location& where, const std::string& sentence);
  static std::vector<std::string> texts(std::vector<Entry> entries);
  std::vector<Entry> errors_, notes_;
};

/// The allowed name that `given` most probably stands for; empty when none is near. Nearness is the
/// Damerau-Levenshtein distance without regard to case, at most a third of the length (at least 1).
std::string nearest_name(const std::string& given, const std::vector<std::string>& allowed);

/// "; did you mean 'density'?" or, when nothing is near, "". Ready to be appended to a sentence.
std::string did_you_mean(const std::string& given, const std::vector<std::string>& allowed);

/// "a, b, c"; "none" for no words.
std::string listed(const std::vector<std::string>& words);

/// What a user wrote, fit for a message: in quotes, on one line, long texts cut short.
std::string quoted(const std::string& given);

}  // namespace hawser
