#pragma once
// Stable: part of the interface for programs that embed Hawser (doc/embedding.md).
#include <mpi.h>

#include <functional>
#include <memory>
#include <string>

#include "hawser/base/communicator.hpp"
#include "hawser/simulation/registries.hpp"

namespace hawser {

class ParallelRuntime;

/// Where runs live: MPI and Kokkos, what decks may name, the folder of plug-ins.
/// Cases and steppers made from it must be gone before it goes.
class Environment {
 public:
  /// On all ranks of the program. Starts MPI and Kokkos unless they run; what it started ends with
  /// it, and MPI does not start twice in a process.
  Environment();
  /// On the ranks of `adopted`, whose MPI the caller has started and will end. MPI_COMM_NULL: one
  /// process that never starts MPI or Kokkos; it can read decks, not run them.
  explicit Environment(MPI_Comm adopted);
  ~Environment();
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

  const Communicator& communicator() const { return communicator_; }

  /// The folder of plug-ins beside the libraries of this installation or build.
  static std::string plugins_beside();
  /// Registers what a shared library in plugin_folder holds, as a deck's <plugin> does for its
  /// case. PluginError.
  void load_plugin(const std::string& name);

  /// What `work` returns; an Error becomes its sentence on standard error and its exit code. Any
  /// other exception, which may be this rank's alone, ends all ranks.
  int guarded(const std::function<int()>& work) const;

  Registries registries;      ///< modules and reports: the built-in ones, and what is added here
  std::string plugin_folder;  ///< at first plugins_beside()

 private:
  std::unique_ptr<ParallelRuntime> runtime_;  // null with MPI_COMM_NULL
  Communicator communicator_;
};

}  // namespace hawser
