// One run, one folder: whoever else comes is told who has it.
#include "src/run_lock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <vector>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class RunLockTest : public testing::Test {
 protected:
  RunLockTest() {
    std::filesystem::remove_all("locked");
    std::filesystem::create_directory("locked");
  }

  static std::string text() {
    std::ostringstream all;
    all << std::ifstream("locked/lock").rdbuf();
    return all.str();
  }
  /// What another process says when it tries, and then is killed with what it holds.
  static int in_another_process(const std::function<int()>& work) {
    const pid_t child = fork();
    if (child == 0) {
      const int code = work();
      _exit(code);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
};

TEST_F(RunLockTest, IsHeldAsLongAsItLives) {
  {
    const RunLock lock("locked");
    EXPECT_THAT(text(), HasSubstr(" " + std::to_string(getpid()) + " "));
    EXPECT_THAT([] { RunLock("locked"); },
                ThrowsMessage<OutputError>(AllOf(HasSubstr("locked is in use by a run: process " +
                                                           std::to_string(getpid()) + " on "),
                                                 HasSubstr("--force does not help"))));
    EXPECT_EQ(in_another_process([] {
                try {
                  const RunLock other("locked");
                  return 0;
                } catch (const OutputError&) {
                  return 7;
                }
              }),
              7);
  }
  EXPECT_TRUE(std::filesystem::is_empty("locked"));
  EXPECT_NO_THROW(RunLock("locked"));
}

TEST_F(RunLockTest, OfAKilledProcessIsTakenOver) {
  EXPECT_EQ(in_another_process([] {
              const RunLock lock("locked");
              std::raise(SIGKILL);
              return 0;
            }),
            -SIGKILL);
  ASSERT_TRUE(std::filesystem::exists("locked/lock"));
  const RunLock lock("locked");
  EXPECT_THAT(text(), HasSubstr(" " + std::to_string(getpid()) + " "));
}

TEST_F(RunLockTest, OfAnotherHostIsLeftAlone) {
  std::ofstream("locked/lock") << "far.example.org 1 2 boot 2020-01-01 00:00:00 UTC\n";
  EXPECT_THAT([] { RunLock("locked"); },
              ThrowsMessage<OutputError>(
                  AllOf(HasSubstr("process 1 on far.example.org, since 2020-01-01 00:00:00 UTC"),
                        HasSubstr("if it is gone, remove locked/lock"))));
  EXPECT_TRUE(std::filesystem::exists("locked/lock"));
}

TEST_F(RunLockTest, ThatIsStillBeingWrittenCountsAsHeld) {
  std::ofstream("locked/lock").flush();
  EXPECT_THAT([] { RunLock("locked"); },
              ThrowsMessage<OutputError>(HasSubstr("has not said who it is yet")));
}

TEST_F(RunLockTest, GoesToOneOfManyWhoComeAtOnce) {
  constexpr int contenders = 8;
  for (const bool stale : {false, true}) {
    std::filesystem::remove("locked/lock");
    if (stale)
      in_another_process([] {
        const RunLock lock("locked");
        std::raise(SIGKILL);
        return 0;
      });
    int start[2], end[2];
    ASSERT_EQ(pipe(start), 0);
    ASSERT_EQ(pipe(end), 0);
    std::vector<pid_t> children;
    for (int i = 0; i < contenders; ++i) {
      const pid_t child = fork();
      if (child != 0) {
        children.push_back(child);
        continue;
      }
      char go = 0;
      close(start[1]);
      close(end[1]);
      if (read(start[0], &go, 1) != 0) _exit(2);
      try {
        const RunLock lock("locked");
        if (read(end[0], &go, 1) != 0) _exit(2);  // until all have tried
        _exit(0);
      } catch (const OutputError&) {
        _exit(7);
      }
    }
    close(start[0]);
    close(start[1]);  // all go at once
    int winners = 0, losers = 0;
    for (std::size_t ended = 0; ended + 1 < children.size(); ++ended) {
      int status = 0;
      wait(&status);
      losers += WIFEXITED(status) && WEXITSTATUS(status) == 7 ? 1 : 0;
    }
    close(end[0]);
    close(end[1]);
    int status = 0;
    wait(&status);
    winners += WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 1 : 0;
    EXPECT_EQ(losers, contenders - 1) << (stale ? "stale" : "none");
    EXPECT_EQ(winners, 1);
  }
}

}  // namespace
}  // namespace hawser
