#pragma once
#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/read_deck.hpp"
#include "hawser/simulation/environment.hpp"

namespace hawser::program {

/// What there is to say of a study without faults; none when `file` is no study but a deck.
/// Collective; DeckError.
std::optional<std::string> check_study(const Environment& environment, const std::string& file);

/// --set: values of the deck that are replaced.
void add_changes(CLI::App& verb, std::vector<DeckChange>& changes);

/// --plugin-dir: another folder than that beside the libraries, which `folder` is set to.
void add_plugin_folder(CLI::App& verb, std::string& folder);

}  // namespace hawser::program
