#pragma once
#include <CLI/CLI.hpp>

#include "hawser/simulation/simulation.hpp"

namespace hawser::program {

/// --set: values of the deck that are replaced.
void add_changes(CLI::App& verb, RunOptions& options);

}  // namespace hawser::program
