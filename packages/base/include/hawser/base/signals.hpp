#pragma once
// What the operating system asks of a run. SIGTERM, SIGINT and SIGUSR2: write a checkpoint and
// stop; SIGUSR1: write a checkpoint and go on. (mpirun kills its ranks a second after a SIGTERM or
// SIGINT of its own; SIGUSR1 and SIGUSR2 it forwards and leaves at that.)
#include <csignal>
#include <string>

#include "hawser/base/communicator.hpp"

namespace hawser {

struct Request {
  enum class Kind { none, checkpoint, stop };
  Kind kind = Kind::none;
  std::string signal;  ///< its name
};

/// Takes the signals while it lives; one at a time. A second signal to stop ends the process at
/// once.
class Signals {
 public:
  /// On return every rank takes them. Collective.
  explicit Signals(const Communicator& communicator);
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// The strongest request that reached any rank since the last call, the same on all. Collective.
  Request take() const;

 private:
  static constexpr int count = 4;
  Communicator communicator_;
  struct sigaction before_[count] = {};
};

}  // namespace hawser
