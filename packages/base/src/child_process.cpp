#include "hawser/base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "hawser/base/error.hpp"

extern char** environ;

namespace hawser {
namespace {

// Debian's gmsh is linked to MPI: told of mpirun, it would take itself for one of the ranks.
bool is_of_mpirun(const char* variable) {
  for (const char* prefix : {"OMPI_", "PMIX_", "PRTE_", "PMI_"}) {
    if (std::strncmp(variable, prefix, std::strlen(prefix)) == 0) return true;
  }
  return false;
}

class Pipe {
 public:
  Pipe() {
    // Closed on exec: a child started elsewhere at the same time must not keep it open.
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) {
      throw OutputError(std::string("cannot make a pipe: ") + std::strerror(errno));
    }
  }
  ~Pipe() {
    close_writing();
    close(ends_[0]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading() const { return ends_[0]; }
  int writing() const { return ends_[1]; }
  void close_writing() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{};
};

// Both at once: a child that fills one pipe while we wait for the other would never end.
void read_all(const Pipe& out, const Pipe& err, ChildResult& result) {
  std::array<pollfd, 2> watched = {pollfd{out.reading(), POLLIN, 0},
                                   pollfd{err.reading(), POLLIN, 0}};
  const std::array<std::string*, 2> texts = {&result.output, &result.errors};
  while (watched[0].fd >= 0 || watched[1].fd >= 0) {
    if (poll(watched.data(), watched.size(), -1) < 0) continue;  // interrupted by a signal
    for (std::size_t k = 0; k < watched.size(); ++k) {
      if (watched[k].fd < 0 || watched[k].revents == 0) continue;
      std::array<char, 4096> buffer;
      const auto size = read(watched[k].fd, buffer.data(), buffer.size());
      if (size > 0) texts[k]->append(buffer.data(), static_cast<std::size_t>(size));
      if (size == 0 || (size < 0 && errno != EINTR)) watched[k].fd = -1;
    }
  }
}

}  // namespace

ChildResult run_child(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const auto& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  std::vector<char*> environment;
  for (char** variable = environ; *variable; ++variable) {
    if (!is_of_mpirun(*variable)) environment.push_back(*variable);
  }
  environment.push_back(nullptr);

  Pipe out, err;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.writing(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.writing(), STDERR_FILENO);
  // Signals to a group of processes are this program's to obey: when it stops early it does so
  // after the child has finished.
  sigset_t blocked;
  sigemptyset(&blocked);
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGUSR2, SIGHUP, SIGXCPU})
    sigaddset(&blocked, signal);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t as_ever;
  sigemptyset(&as_ever);
  for (const int signal : {SIGPIPE, SIGXFSZ})
    sigaddset(&as_ever, signal);
  posix_spawnattr_setsigdefault(&attributes, &as_ever);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setsigmask(&attributes, &blocked);
  pid_t child = 0;
  const int error =
      posix_spawn(&child, program.c_str(), &actions, &attributes, words.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw OutputError("cannot run " + program + ": " + std::strerror(error));

  out.close_writing();
  err.close_writing();
  ChildResult result;
  read_all(out, err, result);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return result;
}

}  // namespace hawser
