#include "src/plugins.hpp"

#include <cstdlib>

#include "hawser/base/error.hpp"
#include "hawser/base/rehearsal.hpp"

namespace hawser {
namespace {

using Tell = std::function<void(const std::string&)>;
const Tell untold = [](const std::string&) {};

/// s, that loading all plug-ins and making all modules may take.
double patience() {
  constexpr double by_default = 60;
  const char* const given = std::getenv("HAWSER_PLUGIN_SECONDS");
  const double seconds = given == nullptr ? by_default : std::atof(given);
  return seconds > 0 ? seconds : by_default;
}

std::string called(const PluginDeck& plugin) {
  const bool of_deck = plugin.name.location.line > 0;
  return (of_deck ? plugin.name.location.text() + ": " : "") + "plug-in '" + plugin.name.value +
         "'";
}

PluginOfTag load(const std::string& folder, const std::vector<PluginDeck>& plugins,
                 Registries& registries, const Tell& tell) {
  PluginOfTag result;
  for (const PluginDeck& plugin : plugins) {
    tell(called(plugin));
    const ModuleRegistry before = registries.modules;
    try {
      load_plugin(plugin.name.value, folder, registries);
    } catch (const PluginError& error) {
      if (plugin.name.location.line == 0) throw;
      throw PluginError(plugin.name.location.text() + ": " + error.what());
    }
    for (const std::string& tag : registries.modules.tags())
      if (before.find(tag) == nullptr) result[tag] = plugin.name.value;
  }
  return result;
}

std::vector<PhysicsModule> make(const Deck& text, const RunDeck& deck,
                                const ModuleRegistry& registry, const PluginOfTag& plugins,
                                Diagnostics& diagnostics, const Tell& tell) {
  std::vector<PhysicsModule> modules;
  for (const DeckNode& node : deck.modules.modules) {
    if (!is_known_child(node, "modules", registry.tags(), diagnostics)) continue;
    const auto plugin = plugins.find(node.tag);
    const bool foreign = plugin != plugins.end();
    const std::string who = node.location.text() + ": plug-in '" +
                            (foreign ? plugin->second : std::string()) + "': module <" + node.tag +
                            ">";
    if (foreign) tell(who);
    try {
      modules.push_back(registry.find(node.tag)->make(node, {deck.mesh.dimension()}, diagnostics));
    } catch (const Error&) {
      throw;
    } catch (const std::exception& error) {
      if (!foreign) throw;
      throw PluginError(who + " cannot be made: " + error.what());
    } catch (...) {
      if (!foreign) throw;
      throw PluginError(who + " cannot be made: it threw something that is no std::exception");
    }
    modules.back().location = node.location;
    if (foreign) modules.back().plugin = plugin->second;
  }
  if (modules.empty() && diagnostics.ok())
    diagnostics.error(text.root.find_child("modules")->location,
                      "<modules> is empty; there are " + listed(registry.tags()));
  return modules;
}

}  // namespace

PluginOfTag load_plugins(const Communicator& communicator, const std::string& folder,
                         const std::vector<PluginDeck>& plugins, Registries& registries) {
  PluginOfTag result;
  communicator.together([&] { result = load(folder, plugins, registries, untold); });
  return result;
}

std::vector<PhysicsModule> make_modules(const Deck& text, const RunDeck& deck,
                                        const ModuleRegistry& registry, const PluginOfTag& plugins,
                                        Diagnostics& diagnostics) {
  return make(text, deck, registry, plugins, diagnostics, untold);
}

void rehearse_plugins(const Communicator& communicator, const std::string& folder,
                      const std::vector<PluginDeck>& plugins, const Registries& registries,
                      const Deck* text, const RunDeck* deck) {
  if (plugins.empty()) return;
  communicator.on_root([&] {
    const Rehearsal rehearsal = rehearse(
        [&](const Tell& tell) {
          Registries copy = registries;
          const PluginOfTag of_tag = load(folder, plugins, copy, tell);
          Diagnostics ignored;
          if (deck != nullptr) make(*text, *deck, copy.modules, of_tag, ignored, tell);
        },
        patience());
    if (!rehearsal.fault.empty())
      throw PluginError(rehearsal.last +
                        (deck == nullptr || rehearsal.last.find("module") == std::string::npos
                             ? " fails while it is loaded: it "
                             : " cannot be made: it ") +
                        rehearsal.fault);
  });
}

}  // namespace hawser
