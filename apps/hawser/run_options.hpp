#pragma once
#include <CLI/CLI.hpp>

#include "hawser/deck/read_deck.hpp"

namespace hawser::program {

/// --set: values of the deck that are replaced.
void add_changes(CLI::App& verb, std::vector<DeckChange>& changes);

/// --plugin-dir: another folder than that beside the libraries, which `folder` is set to.
void add_plugin_folder(CLI::App& verb, std::string& folder);

}  // namespace hawser::program
