#pragma once
// Plug-ins of a case: what they do when they are loaded and when their modules are made may be
// anything, and ends in one sentence with their name.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/simulation/registries.hpp"
#include "hawser/simulation/run_deck.hpp"

namespace hawser {

/// From a module's tag to the name of the plug-in that it comes from.
using PluginOfTag = std::map<std::string, std::string>;

/// A fault has the place of the plug-in in the deck. Collective.
PluginOfTag load_plugins(const Communicator& communicator, const std::string& folder,
                         const std::vector<PluginDeck>& plugins, Registries& registries);

/// Of the deck's modules, in its order. PluginError when one of a plug-in throws what is no Error.
std::vector<PhysicsModule> make_modules(const Deck& text, const RunDeck& deck,
                                        const ModuleRegistry& registry, const PluginOfTag& plugins,
                                        Diagnostics& diagnostics);

/// Loads the plug-ins and makes the modules on rank 0 where it does no harm. PluginError on all
/// ranks when that ends the process, or not at all. Collective.
void rehearse_plugins(const Communicator& communicator, const std::string& folder,
                      const std::vector<PluginDeck>& plugins, const Registries& registries,
                      const Deck* text = nullptr, const RunDeck* deck = nullptr);

}  // namespace hawser
