#pragma once
// What a person sees while a run goes on. Rank 0 prints, to standard output.
#include <chrono>
#include <string>

#include "hawser/output/summary.hpp"
#include "src/system.hpp"

namespace hawser {

class Progress {
 public:
  Progress(const Communicator& communicator, bool quiet);

  void note(const std::string& sentence) const;
  void start(const System& system, const RunDeck& deck);
  void solved(const NonlinearReport& report);
  void rejected(double time, double length, const std::string& why) const;
  void stepped(const StepFigures& figures, double end);
  void finish(const System& system, const RunDeck& deck, const Summary& summary,
              const std::string& folder) const;

  double elapsed() const;  ///< s of wall time since start()

 private:
  bool prints_;
  bool warns_;
  std::string norms_;
  std::chrono::steady_clock::time_point start_;
  double first_time_ = -1;
};

}  // namespace hawser
