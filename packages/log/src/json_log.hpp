#pragma once
// The run for programs: one JSON object per line, each with an "event"; numbers in SI, keys end in
// the unit (doc/running.md lists them).

#include "hawser/log/run_log.hpp"

namespace hawser {

class JsonLog : public RunLog {
 public:
  void note(const std::string& sentence) override;
  void start(const RunHeading& heading) override;
  void solved(const NonlinearReport& report) override;
  void rejected(double time, double length, const std::string& why) override;
  void stepped(const Step& step, const MeshFigures& mesh, double end) override;
  void wrote(const std::string& what, int step, double time) override;
  void finish(const std::string& closing, const std::vector<Judgement>& judgements,
              const Summary& summary) override;

 private:
  std::string folder_;
  NonlinearReport newton_;
};

}  // namespace hawser
