// Temporary files that are removed when the user interrupts the program.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

namespace axisc::system {

/// Holds back what ends a program for as long as it lives, so that making a file and remembering it are one step.
class WithoutInterruption {
 public:
  WithoutInterruption();
  WithoutInterruption(WithoutInterruption const&) = delete;
  WithoutInterruption& operator=(WithoutInterruption const&) = delete;
  ~WithoutInterruption();

 private:
  struct Before;
  std::unique_ptr<Before> before_;
};

/// One for each thread, and some more.
inline constexpr std::size_t most_files_at_once = 1100;

/// While it lives, Ctrl-C and a request to end remove this file before they end the program. A signal that is ignored or
/// handled by somebody else stays so. `path` must live longer; of more than `most_files_at_once` the further ones are left.
class RemovedWhenInterrupted {
 public:
  explicit RemovedWhenInterrupted(char const* path);
  RemovedWhenInterrupted(RemovedWhenInterrupted const&) = delete;
  RemovedWhenInterrupted& operator=(RemovedWhenInterrupted const&) = delete;
  ~RemovedWhenInterrupted();

 private:
  std::atomic<char const*>* place_ = nullptr;
};

}  // namespace axisc::system
