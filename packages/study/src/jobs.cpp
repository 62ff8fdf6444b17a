#include "src/jobs.hpp"

#include <fcntl.h>
#include <sched.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <vector>

#include "hawser/base/error.hpp"

extern char** environ;

namespace hawser {
namespace {

volatile std::sig_atomic_t signal_came_in = 0;

extern "C" void note_signal(int number) { signal_came_in = number; }

double now() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(since).count();
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Ours, but for what makes a rank of Open MPI give its processor away at every call: it is meant
/// for ranks that wait for each other, and starves one that runs beside other work.
std::vector<char*> environment_of_a_job() {
  std::vector<char*> result;
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (std::strncmp(*variable, "OMPI_MCA_mpi_yield_when_idle=", 29) != 0)
      result.push_back(*variable);
  result.push_back(nullptr);
  return result;
}

/// Without SA_RESTART: waiting for a job ends when a signal comes in.
void handle(int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigaction(number, &action, nullptr);
}

}  // namespace

Jobs::Jobs() {
  signal_came_in = 0;
  for (const int number : {SIGINT, SIGTERM})
    handle(number, note_signal);
}

Jobs::~Jobs() {
  for (const int number : {SIGINT, SIGTERM})
    handle(number, SIG_DFL);
}

bool Jobs::interrupted() { return signal_came_in != 0; }

void Jobs::start(const Job& job, std::size_t place) {
  std::vector<char*> words;
  for (const std::string& word : job.command)
    words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, job.log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  // A group of its own: Ctrl-C reaches it through us alone, and once.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::vector<char*> environment = environment_of_a_job();
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, words[0], &actions, &attributes, words.data(), environment.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw OutputError("cannot run " + job.command.front() + " with its log in " + job.log + ": " +
                      std::strerror(error));
  running_[child] = {place, now()};
}

void Jobs::run(const std::vector<Job>& jobs, int at_a_time,
               const std::function<void(std::size_t)>& started,
               const std::function<void(std::size_t, const JobResult&)>& ended) {
  std::size_t next = 0;
  bool passed_on = false;
  while (next < jobs.size() || !running_.empty()) {
    while (!interrupted() && next < jobs.size() &&
           running_.size() < static_cast<std::size_t>(at_a_time)) {
      start(jobs[next], next);
      started(next++);
    }
    if (interrupted() && !passed_on) {
      for (const auto& entry : running_)
        kill(-entry.first, SIGTERM);
      passed_on = true;
    }
    if (running_.empty()) return;
    int status = 0;
    rusage usage{};
    const pid_t child = wait4(-1, &status, 0, &usage);
    const auto found = running_.find(child);
    if (found == running_.end()) continue;  // a signal came in
    JobResult result;
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    result.wall = now() - found->second.begin;
    result.cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    const std::size_t place = found->second.place;
    running_.erase(found);
    ended(place, result);
  }
}

int processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

}  // namespace hawser
