#pragma once
// Stable: part of the interface for programs that embed Hawser (doc/embedding.md).
#include <optional>
#include <string>

#include "hawser/log/run_log.hpp"
#include "hawser/output/summary.hpp"
#include "hawser/simulation/case.hpp"

namespace hawser {

struct RunOptions {
  std::string output{};  ///< result folder; that of the checkpoint when empty
  bool force = false;    ///< write over the results of another run
  LogDetail detail = LogDetail::steps;
  bool log_json = false;               ///< one JSON object per line instead of text
  std::optional<double> stop_after{};  ///< s of wall time; then it stops as by a signal
};

/// Steps to the end as the program does: results in a folder, a log on standard output, signals
/// obeyed (base/signals.hpp). Returns what summary.json says. Collective; any Error on all ranks.
Summary run(const Case& run_case, const RunOptions& options);

/// Builds all that a run would, which finds every fault that only the mesh shows, and says what a
/// user may not expect (Stepper::notes()), a line for each; empty when there is nothing.
/// Collective; any Error on all ranks; the text is rank 0's.
std::string check_with_mesh(const Case& run_case);

/// What a run would need: unknowns, memory, mesh quality, Courant number; and the same notes.
/// Writes nothing. Collective; the text is rank 0's.
std::string preview(const Case& run_case);

struct TangentCheck {
  std::string text;  ///< a line per kernel and pair of fields with the worst relative difference
  bool holds = true;
};

/// Compares the tangent of every kernel, in random admissible states of up to 20 cells of this
/// rank, with central differences of its residual. Collective.
TangentCheck check_tangents(const Case& run_case);

/// Makes the case's mesh as `file`, unless it is a file already, and says what it is like.
/// Collective; MeshError on all ranks.
std::string make_mesh(const Case& run_case, const std::string& file);

}  // namespace hawser
