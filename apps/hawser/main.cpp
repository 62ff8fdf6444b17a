// The program: one verb per thing a user does (verb.hpp).
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "hawser/base/error.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "man_page.hpp"
#include "verb.hpp"

namespace {

using namespace hawser;
using namespace hawser::program;

using Action = std::variant<OnRanks, Alone>;

/// Whether this process is to speak before MPI is there to tell: mpirun and its like number theirs.
bool is_first_process() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
    if (const char* const rank = std::getenv(name)) return std::atoi(rank) == 0;
  return true;
}

int perform(const Alone& action) {
  if (!is_first_process()) return 0;
  Environment environment(MPI_COMM_NULL);
  return environment.guarded([&] { return action(environment); });
}

/// When MPI ends HDF5 tries to close what could not be written, and crashes; all else is done.
[[noreturn]] void leave(const Communicator& world, int code) {
  world.any(false);  // mpirun ends all when one goes
  std::fflush(nullptr);
  std::_Exit(code);
}

int perform(const OnRanks& action) {
  // Who reads what is told here may go; the run does not go with him.
  std::signal(SIGPIPE, SIG_IGN);
  Environment environment;
  const int code = environment.guarded([&] { return action(environment); });
  if (code == static_cast<int>(ExitCode::input_output)) leave(environment.communicator(), code);
  return code;
}

/// Without the second blank line before the verbs: all of them fit on a screen of 24 lines.
class OneScreen : public CLI::Formatter {
 public:
  std::string make_subcommands(const CLI::App* app, CLI::AppFormatMode mode) const override {
    const std::string text = CLI::Formatter::make_subcommands(app, mode);
    return text.empty() ? text : text.substr(1);
  }
};

/// Verbs and options that there are not, with the nearest that there is; else the error's own
/// words.
std::string explained(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const auto verbs = app.get_subcommands();  // that were given
  std::vector<std::string> names;
  if (verbs.empty()) {
    if (argc < 2 || argv[1][0] == '-') return error.what();
    for (const CLI::App* verb : app.get_subcommands(nullptr))
      names.push_back(verb->get_name());
    const std::string given = argv[1];
    return "there is no verb '" + given + "'; there are " + listed(names) +
           did_you_mean(given, names);
  }
  const auto rest = verbs.front()->remaining();
  if (rest.empty() || rest.front().compare(0, 2, "--") != 0) return error.what();
  for (const CLI::Option* option : verbs.front()->get_options())
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  const std::string given = rest.front().substr(0, rest.front().find('='));
  return "'" + verbs.front()->get_name() + "' has no option '" + given + "'" +
         did_you_mean(given, names);
}

/// What the command line asks for; help and complaints are actions, too.
Action read_command_line(CLI::App& app, const std::vector<Verb>& verbs, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0)
      return Alone([&app, error](const Environment&) { return app.exit(error); });
    // On ranks: mpirun would end the one that speaks when another one is the first to fail.
    const CLI::Error told(error.get_name(), explained(app, error, argc, argv),
                          error.get_exit_code());
    return OnRanks([&app, told](const Environment& environment) {
      if (environment.communicator().is_root()) app.exit(told);
      return static_cast<int>(ExitCode::usage);
    });
  }
  return std::find_if(verbs.begin(), verbs.end(),
                      [](const Verb& verb) { return verb.command->parsed(); })
      ->action;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Hawser: towed cables in a current, and what else its parts can be put together to do."};
  app.formatter(std::make_shared<OneScreen>());
  app.set_version_flag("--version", HAWSER_VERSION);
  app.require_subcommand(1);
  app.footer("hawser VERB --help says more about each, with an example. Manual: man hawser");
  // For the build, which installs what it prints; no group: not in the help.
  app.add_flag_callback(
         "--man", [&app] { throw CLI::CallForVersion(man_page(app), 0); }, "print the manual page")
      ->group("");
  std::vector<Verb> verbs;
  for (const auto& group :
       {run_verbs, converge_verbs, info_verbs, deck_verbs, study_verbs, replay_verbs})
    for (Verb& verb : group(app))
      verbs.push_back(std::move(verb));
  const Action action = read_command_line(app, verbs, argc, argv);
  return std::visit([](const auto& what) { return perform(what); }, action);
}
