#include "hawser/log/run_log.hpp"

#include "src/console_log.hpp"
#include "src/json_log.hpp"

namespace hawser {

std::unique_ptr<RunLog> make_run_log(const Communicator& communicator, LogDetail detail,
                                     bool json) {
  if (!communicator.is_root()) return std::make_unique<RunLog>();
  if (json) return std::make_unique<JsonLog>();
  return std::make_unique<ConsoleLog>(detail);
}

}  // namespace hawser
