#include "hawser/base/signals.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace hawser {
namespace {

constexpr int stops[] = {SIGTERM, SIGINT, SIGUSR2};
constexpr int taken[] = {SIGTERM, SIGINT, SIGUSR2, SIGUSR1};

// A handler sees nothing but what is global, and may do nothing but set such flags.
volatile std::sig_atomic_t stop_signal = 0;
volatile std::sig_atomic_t checkpoint_signal = 0;

extern "C" void note_checkpoint(int signal) { checkpoint_signal = signal; }

extern "C" void note_stop(int signal) {
  if (stop_signal == 0) {
    stop_signal = signal;
    return;
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // delivered as soon as this handler returns
}

bool is_stop(int signal) {
  return std::find(std::begin(stops), std::end(stops), signal) != std::end(stops);
}

}  // namespace

Signals::Signals(const Communicator& communicator) : communicator_(communicator) {
  stop_signal = 0;
  checkpoint_signal = 0;
  for (int i = 0; i < count; ++i) {
    struct sigaction action = {};
    action.sa_handler = is_stop(taken[i]) ? note_stop : note_checkpoint;
    action.sa_flags = SA_RESTART;  // what is being written or received goes on
    sigaction(taken[i], &action, &before_[i]);
  }
  communicator_.any(false);  // waits for all
}

Signals::~Signals() {
  for (int i = 0; i < count; ++i)
    sigaction(taken[i], &before_[i], nullptr);
}

Request Signals::take() const {
  constexpr int stop_weight = 1000;  // above any signal's number
  int strongest = stop_signal != 0 ? stop_weight + stop_signal : checkpoint_signal;
  checkpoint_signal = 0;
  strongest = static_cast<int>(communicator_.max(strongest));
  if (strongest == 0) return {};
  const int signal = strongest % stop_weight;
  return {strongest > stop_weight ? Request::Kind::stop : Request::Kind::checkpoint,
          std::string("SIG") + sigabbrev_np(signal)};
}

}  // namespace hawser
