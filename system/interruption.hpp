// Temporary files that are removed when the user interrupts the program.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

namespace axisc::system {

/// Blocks signals that would end the program, so that a file is made and registered in one step.
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

/// While it lives, Ctrl-C and a request to end remove this file before they end the program. A signal that is
/// ignored or handled elsewhere stays so. `path` must outlive this; files beyond `most_files_at_once` are not
/// removed.
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
