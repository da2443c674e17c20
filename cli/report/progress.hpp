// A line on standard error that says how far a long command is.
#pragma once

#include "cli/report/console.hpp"
#include "diagnostics/message.hpp"

#include <chrono>
#include <cstddef>
#include <vector>

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
  /// The same with a count and how many come per second. Nothing in the first half second: most runs are over then.
  void show(std::size_t done, std::size_t count);
  /// Takes the line away before `console` prints, so that the two do not mix on a terminal. Until this is gone.
  void stand_aside_for(Console& console);

 private:
  [[nodiscard]] bool is_due();
  void hide();
  void draw(double share, Message const& message);

  bool shown_;
  Language language_;
  bool written_ = false;
  std::chrono::steady_clock::time_point const begun_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_{};
  std::vector<Console*> consoles_;
};

/// Standard error is a terminal.
[[nodiscard]] bool progress_is_seen();

}  // namespace axisc::cli
