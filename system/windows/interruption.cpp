#include "system/interruption.hpp"

#include "system/windows/wide.hpp"

#include <array>
#include <windows.h>

namespace axisc::system {

namespace {

using Path = std::atomic<char const*>;
std::array<Path, most_files_at_once> paths;

std::atomic<unsigned> makers{0};  // threads that have made a file and not registered it yet
std::atomic<bool> is_ending{false};

/// Windows calls it in a thread of its own.
BOOL WINAPI remove_files(DWORD /*event*/) {
  is_ending = true;
  // Not for ever: a file that stays behind is better than a program that cannot be ended.
  for (int i = 0; i < 1000 && makers > 0; ++i) ::Sleep(1);
  for (Path const& path : paths) {
    if (char const* const name = path.load(); name != nullptr) ::DeleteFileW(wide_path(name).c_str());
  }
  return FALSE;  // the next handler ends the program
}

void handle_events() {
  static bool const is_handled = ::SetConsoleCtrlHandler(remove_files, TRUE) != 0;
  static_cast<void>(is_handled);
}

}  // namespace

struct WithoutInterruption::Before {};

WithoutInterruption::WithoutInterruption() {
  ++makers;
  if (!is_ending) return;
  --makers;
  ::Sleep(INFINITE);
}

WithoutInterruption::~WithoutInterruption() {
  --makers;
}

RemovedWhenInterrupted::RemovedWhenInterrupted(char const* path) {
  handle_events();
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
