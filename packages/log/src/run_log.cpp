#include "hawser/log/run_log.hpp"

#include "src/console_log.hpp"
#include "src/json_log.hpp"

namespace hawser {
namespace {

/// Of a rank that is not to speak.
class NoLog : public RunLog {
 public:
  void note(const std::string& /*sentence*/) override {}
  void start(const RunHeading& /*heading*/) override {}
  void solved(const NonlinearReport& /*report*/) override {}
  void rejected(double /*time*/, double /*length*/, const std::string& /*why*/) override {}
  void stepped(const Step& /*step*/, const MeshFigures& /*mesh*/, double /*end*/) override {}
  void wrote(const std::string& /*what*/, int /*step*/, double /*time*/) override {}
  void finish(const std::string& /*closing*/, const std::vector<Judgement>& /*judgements*/,
              const Summary& /*summary*/) override {}
};

}  // namespace

std::unique_ptr<RunLog> make_run_log(const Communicator& communicator, LogDetail detail,
                                     bool json) {
  if (!communicator.is_root()) return std::make_unique<NoLog>();
  if (json) return std::make_unique<JsonLog>();
  return std::make_unique<ConsoleLog>(detail);
}

}  // namespace hawser
