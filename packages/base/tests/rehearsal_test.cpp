#include "hawser/base/rehearsal.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace hawser {
namespace {

using Tell = std::function<void(const std::string&)>;

TEST(Rehearsal, OfWhatReturnsOrThrowsFindsNoFault) {
  int touched = 0;
  const Rehearsal good = rehearse(
      [&](const Tell& tell) {
        touched = 1;
        tell("first");
        tell("second");
      },
      60);
  EXPECT_EQ(good.fault, "");
  EXPECT_EQ(good.last, "second");
  EXPECT_EQ(touched, 0) << "it was a copy that did it";
  EXPECT_EQ(rehearse([](const Tell&) { throw std::runtime_error("no"); }, 60).fault, "");
}

TEST(Rehearsal, SaysHowItEndsAndWhere) {
  const Rehearsal hung = rehearse(
      [](const Tell& tell) {
        tell("the endless one");
        for (volatile bool on = true; on;) {
        }
      },
      0.2);
  EXPECT_EQ(hung.fault, "does not come back within 0.2 s");
  EXPECT_EQ(hung.last, "the endless one");
  EXPECT_EQ(rehearse([](const Tell&) { std::raise(SIGSEGV); }, 60).fault,
            "ends the program with signal SIGSEGV");
  EXPECT_EQ(rehearse([](const Tell&) { std::quick_exit(0); }, 60).fault,
            "ends the program with exit code 0");
}

}  // namespace
}  // namespace hawser
