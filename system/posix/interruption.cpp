#include "system/interruption.hpp"

#include <array>
#include <csignal>
#include <ctime>
#include <unistd.h>

namespace axisc::system {

namespace {

constexpr std::array ending_signals = {SIGINT, SIGTERM, SIGHUP};

// A handler has no other way to access these. It may read atomics without locks, and unlink() is safe in it.
using Path = std::atomic<char const*>;
static_assert(Path::is_always_lock_free);
std::array<Path, most_files_at_once> paths;

// A signal reaches one thread while others continue.
std::atomic<unsigned> makers{0};  // threads that have made a file and not registered it yet
std::atomic<bool> is_ending{false};

void wait_a_millisecond() {
  timespec const time{.tv_sec = 0, .tv_nsec = 1'000'000};
  static_cast<void>(::nanosleep(&time, nullptr));
}

extern "C" void remove_files(int signal) {
  is_ending = true;
  // Not for ever: a file that stays behind is better than a program that cannot be ended.
  for (int i = 0; i < 1000 && makers > 0; ++i) wait_a_millisecond();
  for (Path const& path : paths) {
    if (char const* const name = path.load(); name != nullptr) ::unlink(name);
  }
  // The handler is reset: this ends the program as soon as it returns, and the caller sees the signal.
  static_cast<void>(::raise(signal));
}

void handle_signals() {
  for (int const signal : ending_signals) {
    struct sigaction action {};
    bool const is_default = ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_DFL;
    if (!is_default) continue;
    action.sa_handler = remove_files;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    static_cast<void>(::sigaction(signal, &action, nullptr));
  }
}

}  // namespace

struct WithoutInterruption::Before {
  sigset_t signals{};
};

WithoutInterruption::WithoutInterruption() : before_(std::make_unique<Before>()) {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (int const signal : ending_signals) ::sigaddset(&signals, signal);
  static_cast<void>(::pthread_sigmask(SIG_BLOCK, &signals, &before_->signals));
  ++makers;
  if (!is_ending) return;
  --makers;
  while (true) wait_a_millisecond();
}

WithoutInterruption::~WithoutInterruption() {
  --makers;
  static_cast<void>(::pthread_sigmask(SIG_SETMASK, &before_->signals, nullptr));
}

RemovedWhenInterrupted::RemovedWhenInterrupted(char const* path) {
  handle_signals();
  for (Path& place : paths) {
    char const* none = nullptr;
    if (place.compare_exchange_strong(none, path)) {
      place_ = &place;
      return;
    }
  }
}

RemovedWhenInterrupted::~RemovedWhenInterrupted() {
  if (place_ != nullptr) place_->store(nullptr);
}

}  // namespace axisc::system
