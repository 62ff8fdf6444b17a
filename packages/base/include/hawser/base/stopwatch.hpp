#pragma once
#include <chrono>

namespace hawser {

/// Adds up the wall time of a phase that is entered many times. For reports only: no decision of a
/// run may rest on it.
class Stopwatch {
 public:
  class Lap {
   public:
    explicit Lap(Stopwatch& watch) : watch_(watch), start_(Clock::now()) {}
    ~Lap() { watch_.seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

   private:
    Stopwatch& watch_;
    std::chrono::steady_clock::time_point start_;
  };

  Lap lap() { return Lap(*this); }
  double seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_ = 0;
};

/// Wall time since it was made. Ranks must agree before they act on it.
class Clock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace hawser
