#include "hawser/base/rehearsal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

constexpr int done = 90;  // the copy's exit code; any other one is not its own decision

using Tell = std::function<void(const std::string&)>;

[[noreturn]] void perform(const std::function<void(const Tell&)>& work, int out) {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGSEGV, SIGABRT,
                           SIGBUS, SIGFPE, SIGILL})
    std::signal(signal, SIG_DFL);  // MPI's handlers would tell stories
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  try {
    work([out](const std::string& what) {
      const std::string line = what + "\n";
      if (write(out, line.data(), line.size()) < 0) _exit(1);
    });
  } catch (...) {  // comes again in earnest
  }
  _exit(done);  // nothing of this process is to be ended twice
}

std::string last_line(const std::string& text) {
  if (text.empty()) return "";
  const std::size_t begin = text.rfind('\n', text.size() - 2);
  return text.substr(begin == std::string::npos ? 0 : begin + 1,
                     text.size() - 1 - (begin == std::string::npos ? 0 : begin + 1));
}

/// What the copy told; false when it took longer.
bool listen(int in, double seconds, std::string& told) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    if (left <= 0) return false;
    pollfd watched = {in, POLLIN, 0};
    const int ready = poll(&watched, 1, static_cast<int>(left));
    if (ready < 0 && errno != EINTR) return false;
    if (ready <= 0) continue;
    std::array<char, 4096> buffer;
    const ssize_t size = read(in, buffer.data(), buffer.size());
    if (size == 0) return true;
    if (size > 0) told.append(buffer.data(), static_cast<std::size_t>(size));
  }
}

}  // namespace

Rehearsal rehearse(const std::function<void(const Tell& tell)>& work, double seconds) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw OutputError(std::string("cannot make a pipe: ") + std::strerror(errno));
  std::fflush(nullptr);  // or the copy would write it, too
  const pid_t copy = fork();
  if (copy < 0) {
    close(ends[0]);
    close(ends[1]);
    throw OutputError(std::string("cannot start a process: ") + std::strerror(errno));
  }
  if (copy == 0) perform(work, ends[1]);
  close(ends[1]);
  std::string told;
  const bool ended = listen(ends[0], seconds, told);
  close(ends[0]);
  if (!ended) kill(copy, SIGKILL);
  int status = 0;
  while (waitpid(copy, &status, 0) < 0 && errno == EINTR) {
  }
  Rehearsal result{"", last_line(told)};
  if (!ended) {
    char text[64];
    std::snprintf(text, sizeof text, "does not come back within %g s", seconds);
    result.fault = text;
  } else if (WIFSIGNALED(status)) {
    result.fault = std::string("ends the program with signal SIG") + sigabbrev_np(WTERMSIG(status));
  } else if (WEXITSTATUS(status) != done) {
    result.fault = "ends the program with exit code " + std::to_string(WEXITSTATUS(status));
  }
  return result;
}

}  // namespace hawser
