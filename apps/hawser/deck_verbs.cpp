// What a deck may say.
#include <cstdio>

#include "hawser/base/error.hpp"
#include "hawser/simulation/deck_parameters.hpp"
#include "known_modules.hpp"
#include "verb.hpp"

namespace hawser::program {
namespace {

int list_modules() {
  const ModuleRegistry registry = built_in_modules();
  for (const std::string& tag : registry.tags())
    std::printf("%-14s %s\n", tag.c_str(), registry.find(tag)->spec.meaning.c_str());
  return 0;
}

int describe_module(const std::string& tag) {
  const ModuleRegistry registry = built_in_modules();
  const ModuleRegistry::Entry* const module = registry.find(tag);
  if (module == nullptr && !tag.empty())
    throw Error(ExitCode::usage, "there is no module '" + tag + "'; there are " +
                                     listed(registry.tags()) + did_you_mean(tag, registry.tags()));
  std::fputs(describe(module ? module->spec : RunDeck::spec().node_spec()).c_str(), stdout);
  return 0;
}

}  // namespace

std::vector<Verb> deck_verbs(CLI::App& app) {
  auto* modules = app.add_subcommand("modules", "list the physics modules");
  auto* describe =
      app.add_subcommand("describe", "describe a module's parameters, or all of a deck");
  const auto tag = std::make_shared<std::string>();
  describe->add_option("module", *tag, "tag of a module");
  return {{modules, Alone(list_modules)},
          {describe, Alone([tag] { return describe_module(*tag); })}};
}

}  // namespace hawser::program
