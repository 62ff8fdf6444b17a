#pragma once
// A verb is one thing that a user does. It adds its subcommand to the command line and says what is
// to be done when that was given; files of verbs know nothing of each other.
#include <CLI/CLI.hpp>

#include <functional>
#include <variant>
#include <vector>

#include "hawser/simulation/environment.hpp"

namespace hawser::program {

/// Returns the exit code.
using Work = std::function<int(Environment& environment)>;
/// On all ranks together, with MPI and Kokkos running.
struct OnRanks : Work {
  using Work::Work;
};
/// In one process without MPI, which is never started: quick, and free to start programs that are
/// themselves parallel.
struct Alone : Work {
  using Work::Work;
};

struct Verb {
  CLI::App* command;
  std::variant<OnRanks, Alone> action;
};

std::vector<Verb> run_verbs(CLI::App& app);  ///< run, restart, check, jacobian, mesh
std::vector<Verb> converge_verbs(CLI::App& app);
std::vector<Verb> deck_verbs(CLI::App& app);  ///< modules, describe, schema, new
std::vector<Verb> info_verbs(CLI::App& app);  ///< info
std::vector<Verb> replay_verbs(CLI::App& app);
std::vector<Verb> study_verbs(CLI::App& app);  ///< study, report

}  // namespace hawser::program
