#pragma once
#include <string>

#include "hawser/base/error.hpp"
#include "src/kernel_cells.hpp"

namespace hawser {

/// Remembers the first cell of an element loop that could not be evaluated.
struct CellFailure {
  CellStatus status = CellStatus::ok;
  const KernelCells* cells = nullptr;
  LocalIndex cell = 0;
  std::string sentence;  ///< when an expression of the deck said why
  std::string thrown;    ///< by a module of a plug-in, and no SolveError

  /// `evaluate` gives a CellStatus, or throws SolveError: on this rank only, so far.
  template <class Evaluate>
  void note(Evaluate&& evaluate, const KernelCells& where, LocalIndex which) {
    CellStatus found = CellStatus::not_finite;
    try {
      found = evaluate();
    } catch (const SolveError& error) {
      if (status == CellStatus::ok) sentence = error.what();
    } catch (const Error&) {
      throw;
    } catch (const std::exception& error) {
      if (where.stranger.empty()) throw;
      if (thrown.empty()) thrown = where.stranger + " fails in its equations: " + error.what();
    }
    if (status != CellStatus::ok || found == CellStatus::ok) return;
    status = found;
    cells = &where;
    cell = which;
  }

  /// SolveError on all ranks when any of them met such a cell, PluginError when a plug-in's module
  /// threw there. Collective.
  void throw_together(const Mesh& mesh, const State& state) const;
};

}  // namespace hawser
