#include "hawser/base/signals.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <ctime>

namespace hawser {
namespace {

// A handler sees nothing but what is global, and may do nothing but set such flags.
volatile std::sig_atomic_t stop_signal = 0;
volatile std::sig_atomic_t checkpoint_signal = 0;
std::atomic<long long> first_demand{0};  // ms, of a SIGTERM or SIGINT; 0 before it
static_assert(std::atomic<long long>::is_always_lock_free);

long long now_in_ms() {
  timespec now = {};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * 1000LL + now.tv_nsec / 1000000 + 1;
}

extern "C" void note_checkpoint(int signal) { checkpoint_signal = signal; }

extern "C" void note_stop(int signal) {
  if (stop_signal == 0) stop_signal = signal;
}

// `timeout` and batch systems signal a process and its group, so that one wish arrives twice: only
// what comes later is meant as a second one.
extern "C" void note_demand(int signal) {
  constexpr long long same_wish = 500;  // ms
  note_stop(signal);
  const long long now = now_in_ms();
  long long first = 0;
  if (first_demand.compare_exchange_strong(first, now) || now - first < same_wish) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // delivered as soon as this handler returns
}

struct Taken {
  int signal;
  void (*handler)(int);
};
const Taken all_taken[] = {{SIGTERM, note_demand},
                           {SIGINT, note_demand},
                           {SIGUSR1, note_stop},
                           {SIGHUP, note_stop},
                           {SIGXCPU, note_stop},
                           {SIGUSR2, note_checkpoint},
                           // A write that fails tells so itself, and of the log none needs to.
                           {SIGPIPE, SIG_IGN},
                           {SIGXFSZ, SIG_IGN}};
static_assert(sizeof all_taken / sizeof all_taken[0] == Signals::count);

}  // namespace

Signals::Signals(const Communicator& communicator) : communicator_(communicator) {
  stop_signal = 0;
  checkpoint_signal = 0;
  first_demand = 0;
  for (int i = 0; i < count; ++i) {
    struct sigaction action = {};
    action.sa_handler = all_taken[i].handler;
    action.sa_flags = SA_RESTART;  // what is being written or received goes on
    sigaction(all_taken[i].signal, &action, &before_[i]);
    // Started with nohup, a run is meant to outlive its terminal.
    if (all_taken[i].signal == SIGHUP && before_[i].sa_handler == SIG_IGN)
      sigaction(SIGHUP, &before_[i], nullptr);
  }
  communicator_.any(false);  // waits for all
}

Signals::~Signals() {
  for (int i = 0; i < count; ++i)
    sigaction(all_taken[i].signal, &before_[i], nullptr);
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
