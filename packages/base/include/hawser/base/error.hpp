#pragma once
// The errors a user can meet. Each carries one clear sentence and the program's exit code.
// std::logic_error is left for our own bugs.
#include <stdexcept>
#include <string>

namespace hawser {

enum class ExitCode {
  done = 0,
  usage = 2,
  deck = 3,
  mesh = 4,
  plugin = 5,
  not_converged = 6,
  input_output = 7,
  expectation = 8,  ///< the run finished, but an <expect> of the deck does not hold
  stopped = 75      ///< stopped by a signal, checkpoint written
};

class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The user can mend it in the deck: the message holds file:line:column for every fault.
struct DeckError : Error {
  explicit DeckError(const std::string& message) : Error(ExitCode::deck, message) {}
};
struct MeshError : Error {
  explicit MeshError(const std::string& message) : Error(ExitCode::mesh, message) {}
};
struct PluginError : Error {
  explicit PluginError(const std::string& message) : Error(ExitCode::plugin, message) {}
};
/// Numerical trouble of one step; step control catches it, cuts the step and tries again.
struct SolveError : Error {
  explicit SolveError(const std::string& message) : Error(ExitCode::not_converged, message) {}
};
struct OutputError : Error {
  explicit OutputError(const std::string& message) : Error(ExitCode::input_output, message) {}
};

}  // namespace hawser
