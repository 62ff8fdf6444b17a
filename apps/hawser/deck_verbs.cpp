// What a deck may say.
#include <cstdio>

#include "hawser/base/error.hpp"
#include "hawser/deck/manual.hpp"
#include "hawser/simulation/deck_language.hpp"
#include "hawser/simulation/deck_templates.hpp"
#include "plugin_template.hpp"
#include "run_options.hpp"
#include "verb.hpp"

namespace hawser::program {
namespace {

struct Arguments {
  std::string what;
  std::vector<std::string> plugins;
  std::string plugin_folder;
  bool markdown = false;
};

std::shared_ptr<Arguments> new_arguments(CLI::App& verb) {
  auto arguments = std::make_shared<Arguments>();
  verb.add_option("--plugin", arguments->plugins,
                  "plug-in whose modules and reports are known, too; repeatable")
      ->allow_extra_args(false);
  add_plugin_folder(verb, arguments->plugin_folder);
  return arguments;
}

/// What is built in, and what the plug-ins have.
const Registries& known_to(const Arguments& arguments, Environment& environment) {
  environment.plugin_folder = arguments.plugin_folder;
  for (const std::string& name : arguments.plugins)
    environment.load_plugin(name);
  return environment.registries;
}

int print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  return 0;
}

Verb modules_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("modules", "list the physics modules");
  verb->footer("Example: hawser modules --plugin heat");
  const auto arguments = new_arguments(*verb);
  return {verb, Alone([arguments](Environment& environment) {
            const ModuleRegistry& registry = known_to(*arguments, environment).modules;
            for (const std::string& tag : registry.tags())
              std::printf("%-17s %s\n", tag.c_str(), registry.find(tag)->spec.meaning.c_str());
            return 0;
          })};
}

Verb describe_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("describe", "describe a deck, or what is at a path in it");
  verb->footer("Example: hawser describe time/step");
  const auto arguments = new_arguments(*verb);
  verb->add_option("path", arguments->what,
                   "path, element, attribute or module: solver/newton, cable");
  verb->add_flag("--markdown", arguments->markdown, "all of it, as doc/deck_reference.md");
  return {verb, Alone([arguments](Environment& environment) {
            const DeckLanguage language = deck_language(known_to(*arguments, environment));
            return print(arguments->markdown ? deck_reference(language)
                                             : describe(language, arguments->what));
          })};
}

Verb schema_verb(CLI::App& app) {
  auto* verb =
      app.add_subcommand("schema", "print the XML Schema of decks, for editors and xmllint");
  verb->footer("Example: hawser schema --plugin heat > deck.xsd");
  const auto arguments = new_arguments(*verb);
  return {verb, Alone([arguments](Environment& environment) {
            return print(schema(deck_language(known_to(*arguments, environment))));
          })};
}

int print_template(const std::string& name) {
  std::vector<std::string> names;
  std::string list = "hawser new NAME > my.xml, where NAME is one of\n";
  for (const DeckTemplate& known : deck_templates()) {
    if (known.name == name) return print(known.text);
    names.push_back(known.name);
    list += "  " + known.name + "  " + known.summary() + "\n";
  }
  list += "hawser new plugin NAME makes the folder of a plug-in\n";
  if (name.empty()) return print(list);
  throw Error(ExitCode::usage, "there is no template '" + name + "'; there are " + listed(names) +
                                   did_you_mean(name, names));
}

Verb new_verb(CLI::App& app) {
  auto* verb = app.add_subcommand(
      "new", "print a commented deck to begin with, or make the folder of a plug-in");
  verb->footer("Examples: hawser new tow > my.xml\n          hawser new plugin salinity");
  const auto name = std::make_shared<std::string>(), plugin = std::make_shared<std::string>();
  verb->add_option("template", *name,
                   "a deck's name, or plugin; without one, the names are listed");
  verb->add_option("plugin-name", *plugin, "of a new plug-in and its folder");
  return {verb, Alone([name, plugin](const Environment&) {
            if (*name != "plugin") return print_template(*name);
            write_plugin(*plugin);
            return print("made the folder " + *plugin + "; its README.md says how it is built\n");
          })};
}

}  // namespace

std::vector<Verb> deck_verbs(CLI::App& app) {
  return {modules_verb(app), describe_verb(app), schema_verb(app), new_verb(app)};
}

}  // namespace hawser::program
