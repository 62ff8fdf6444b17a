#pragma once
#include <string>
#include <vector>

namespace hawser {

struct ChildResult {
  int status = 0;  ///< the exit code; negative: the signal that ended it
  std::string output, errors;
};

/// Runs a program and waits for it. The variables by which mpirun tells its children what they are
/// are kept from it. OutputError if it cannot be started.
ChildResult run_child(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace hawser
