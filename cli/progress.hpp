// A line on standard error that says how far a long command is.
#pragma once

#include "diagnostics/text.hpp"

#include <chrono>
#include <string>

namespace axisc::cli {

class Progress {
 public:
  /// `shown`: else nothing is ever written.
  Progress(bool shown, Language language) : shown_(shown), language_(language) {}
  Progress(Progress const&) = delete;
  Progress& operator=(Progress const&) = delete;
  /// Takes the line away.
  ~Progress();

  /// At most ten times a second: a bar, percent, and the seconds of machine time.
  void show(double share, double seconds);

 private:
  bool shown_;
  Language language_;
  bool written_ = false;
  std::chrono::steady_clock::time_point last_{};
};

/// Standard error is a terminal.
[[nodiscard]] bool progress_is_seen();

}  // namespace axisc::cli
