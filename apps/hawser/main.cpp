// The program: one verb per thing a user does (verb.hpp).
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "hawser/base/error.hpp"
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

/// What the command line asks for; help and complaints are actions, too.
Action read_command_line(CLI::App& app, const std::vector<Verb>& verbs, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0)
      return Alone([&app, error](const Environment&) { return app.exit(error); });
    // On ranks: mpirun would end the one that speaks when another one is the first to fail.
    return OnRanks([&app, error](const Environment& environment) {
      if (environment.communicator().is_root()) app.exit(error);
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
  app.set_version_flag("--version", HAWSER_VERSION);
  app.require_subcommand(1);
  app.footer("hawser VERB --help says more about each, with an example. Manual: man hawser");
  // For the build, which installs what it prints; no group: not in the help.
  app.add_flag_callback(
         "--man", [&app] { throw CLI::CallForVersion(man_page(app), 0); }, "print the manual page")
      ->group("");
  std::vector<Verb> verbs;
  for (const auto& group : {run_verbs, converge_verbs, info_verbs, deck_verbs, study_verbs})
    for (Verb& verb : group(app))
      verbs.push_back(std::move(verb));
  const Action action = read_command_line(app, verbs, argc, argv);
  return std::visit([](const auto& what) { return perform(what); }, action);
}
