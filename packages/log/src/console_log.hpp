#pragma once
// What a person sees while a run goes on.
#include <chrono>
#include <string>

#include "hawser/log/run_log.hpp"
#include "src/terminal.hpp"

namespace hawser {

class ConsoleLog : public RunLog {
 public:
  explicit ConsoleLog(LogDetail detail)
      : detail_(detail), start_(std::chrono::steady_clock::now()) {}

  void note(const std::string& sentence) override;
  void warn(const std::string& sentence) override;
  void start(const RunHeading& heading) override;
  void solved(const NonlinearReport& report) override;
  void rejected(double time, double length, const std::string& why) override;
  void stepped(const Step& step, const MeshFigures& mesh, double end) override;
  void wrote(const std::string& what, int step, double time) override;
  void finish(const std::string& closing, const std::vector<Judgement>& judgements,
              const Summary& summary) override;

 private:
  bool tells() const { return detail_ != LogDetail::quiet; }
  void tell(const Judgement& judgement);

  LogDetail detail_;
  Terminal terminal_;
  std::string folder_;
  std::string decides_;
  std::chrono::steady_clock::time_point start_;
  double first_time_ = -1;
};

}  // namespace hawser
