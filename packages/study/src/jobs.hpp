#pragma once
// Programs that run side by side, as many at a time as there is room for.
#include <sys/types.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace hawser {

struct Job {
  std::vector<std::string> command;  ///< program and arguments
  std::string log;                   ///< file that takes what it says
};

struct JobResult {
  int exit_code = 0;  ///< -signal when it was killed
  double wall = 0;    ///< s
  double cpu = 0;     ///< s, of it and of what it started
};

/// While one is there, SIGINT and SIGTERM are passed on to the running jobs, and no further one
/// starts.
class Jobs {
 public:
  Jobs();
  ~Jobs();
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  /// Calls `started` and `ended` with the job's place in `jobs`. OutputError when a program cannot
  /// be started or a log cannot be written.
  void run(const std::vector<Job>& jobs, int at_a_time,
           const std::function<void(std::size_t)>& started,
           const std::function<void(std::size_t, const JobResult&)>& ended);

  static bool interrupted();  ///< a signal came in

 private:
  struct Running {
    std::size_t place = 0;
    double begin = 0;
  };
  void start(const Job& job, std::size_t place);
  std::map<pid_t, Running> running_;
};

/// Processors that this process may use.
int processors();

}  // namespace hawser
