#pragma once
// Work of which nobody knows whether it returns, tried first where it can do no harm.
#include <functional>
#include <string>

namespace hawser {

/// How it went.
struct Rehearsal {
  std::string fault;  ///< "does not come back within 60 s", "ends with signal SEGV"; empty: none
  std::string last;   ///< what the work told last
};

/// Runs `work` in a copy of this process, whose output is lost, for at most so many seconds.
/// Exceptions are no fault: they come again when the work is done in earnest. `work` calls `tell`
/// with what it begins; it must not communicate. OutputError when there can be no copy.
Rehearsal rehearse(
    const std::function<void(const std::function<void(const std::string&)>& tell)>& work,
    double seconds);

}  // namespace hawser
