// What the operating system asks is taken once, and a folder for the time being goes.
#include "hawser/base/signals.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "hawser/base/installation.hpp"
#include "hawser/base/scratch_folder.hpp"

namespace hawser {
namespace {

TEST(Signals, ARequestIsTakenOnce) {
  const Signals signals{Communicator()};
  EXPECT_EQ(signals.take().kind, Request::Kind::none);
  std::raise(SIGUSR2);
  const Request request = signals.take();
  EXPECT_EQ(request.kind, Request::Kind::checkpoint);
  EXPECT_EQ(request.signal, "SIGUSR2");
  EXPECT_EQ(signals.take().kind, Request::Kind::none);
}

TEST(Signals, OneRanksWishToStopIsEveryones) {
  const Communicator all;
  const Signals signals(all);
  if (all.is_root()) std::raise(SIGTERM);
  std::raise(SIGUSR2);
  const Request request = signals.take();
  EXPECT_EQ(request.kind, Request::Kind::stop);
  EXPECT_EQ(request.signal, "SIGTERM");
}

TEST(Signals, OneWishMayArriveTwice) {
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1, SIGHUP, SIGXCPU}) {
    const Signals signals{Communicator()};
    std::raise(signal);
    std::raise(signal);
    EXPECT_EQ(signals.take().signal, std::string("SIG") + sigabbrev_np(signal));
  }
}

TEST(Signals, AHangUpThatWasIgnoredStaysIgnored) {
  std::signal(SIGHUP, SIG_IGN);  // as nohup has it
  {
    const Signals signals{Communicator()};
    std::raise(SIGHUP);
    EXPECT_EQ(signals.take().kind, Request::Kind::none);
  }
  std::signal(SIGHUP, SIG_DFL);
}

void (*handler_of(int signal))(int) {
  struct sigaction present = {};
  sigaction(signal, nullptr, &present);
  return present.sa_handler;
}

TEST(Signals, AreGivenBack) {
  const auto before = handler_of(SIGUSR1);
  {
    const Signals signals{Communicator()};
    EXPECT_NE(handler_of(SIGUSR1), before);
  }
  EXPECT_EQ(handler_of(SIGUSR1), before);
}

TEST(ScratchFolder, GoesWithWhatIsInIt) {
  const Communicator all;
  std::string path;
  {
    const ScratchFolder folder(all);
    path = folder.path();
    EXPECT_TRUE(std::filesystem::is_directory(path));
    all.any(false);  // every rank has looked before one removes it
    if (all.is_root()) std::ofstream(path + "/file") << "text";
    EXPECT_EQ(all.broadcast(path), path);  // one for all ranks
    all.any(false);                        // the root must not be done before others have looked
  }
  all.any(false);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Installation, HoldsTheProgramsOfThisBuild) {
  const auto tests = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  EXPECT_EQ(installation_folder(), tests.parent_path().parent_path());  // of build/tests/bin
}

}  // namespace
}  // namespace hawser
