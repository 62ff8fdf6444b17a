// What a deck may say.
#include <cstdio>

#include "hawser/base/error.hpp"
#include "hawser/simulation/deck_parameters.hpp"
#include "hawser/simulation/plugin_loader.hpp"
#include "known_modules.hpp"
#include "verb.hpp"

namespace hawser::program {
namespace {

struct Arguments {
  std::string tag;
  std::vector<std::string> plugins;
  std::string plugin_folder = default_plugin_folder();
};

std::shared_ptr<Arguments> new_arguments(CLI::App& verb) {
  auto arguments = std::make_shared<Arguments>();
  verb.add_option("--plugin", arguments->plugins, "plug-in to count in, by name; repeatable")
      ->allow_extra_args(false);
  verb.add_option("--plugin-dir", arguments->plugin_folder, "folder that plug-ins are loaded from");
  return arguments;
}

ModuleRegistry modules_of(const Arguments& arguments) {
  ModuleRegistry registry = built_in_modules();
  for (const std::string& plugin : arguments.plugins)
    load_plugin(plugin, arguments.plugin_folder, registry);
  return registry;
}

int list_modules(const Arguments& arguments) {
  const ModuleRegistry registry = modules_of(arguments);
  for (const std::string& tag : registry.tags())
    std::printf("%-14s %s\n", tag.c_str(), registry.find(tag)->spec.meaning.c_str());
  return 0;
}

int describe_module(const Arguments& arguments) {
  const ModuleRegistry registry = modules_of(arguments);
  const std::string& tag = arguments.tag;
  const ModuleRegistry::Entry* const module = registry.find(tag);
  if (module == nullptr && !tag.empty())
    throw Error(ExitCode::usage, "there is no module '" + tag + "'; there are " +
                                     listed(registry.tags()) + did_you_mean(tag, registry.tags()));
  std::fputs(describe(module ? module->spec : RunDeck::spec().node_spec()).c_str(), stdout);
  return 0;
}

Verb modules_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("modules", "list the physics modules");
  verb->footer("Example: hawser modules --plugin heat");
  const auto arguments = new_arguments(*verb);
  return {verb, Alone([arguments] { return list_modules(*arguments); })};
}

Verb describe_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("describe", "describe a module's parameters, or all of a deck");
  verb->footer("Example: hawser describe ale-fluid");
  const auto arguments = new_arguments(*verb);
  verb->add_option("module", arguments->tag, "tag of a module");
  return {verb, Alone([arguments] { return describe_module(*arguments); })};
}

}  // namespace

std::vector<Verb> deck_verbs(CLI::App& app) { return {modules_verb(app), describe_verb(app)}; }

}  // namespace hawser::program
