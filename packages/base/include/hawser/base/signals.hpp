#pragma once
// What the operating system asks of a run. SIGTERM, SIGINT, SIGUSR1, SIGHUP and SIGXCPU: write a
// checkpoint and stop; SIGUSR2: write a checkpoint and go on. (mpirun kills its ranks a second
// after a SIGTERM or SIGINT of its own; SIGUSR1 and SIGUSR2 it forwards and leaves at that.)
#include <csignal>
#include <string>

#include "hawser/base/communicator.hpp"

namespace hawser {

struct Request {
  enum class Kind { none, checkpoint, stop };
  Kind kind = Kind::none;
  std::string signal;  ///< its name
};

/// Takes the signals while it lives; one at a time. A SIGTERM or SIGINT half a second or more after
/// the first one ends the process at once. SIGHUP is left ignored where it was. SIGPIPE and SIGXFSZ
/// are ignored: the write that they are about fails.
class Signals {
 public:
  /// On return every rank takes them. Collective.
  explicit Signals(const Communicator& communicator);
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// The strongest request that reached any rank since the last call, the same on all. Collective.
  Request take() const;

  static constexpr int count = 8;  ///< of signals taken

 private:
  Communicator communicator_;
  struct sigaction before_[count] = {};
};

}  // namespace hawser
