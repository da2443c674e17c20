// A progress line on standard error for long commands.
#pragma once

#include "cli/terminal/console.hpp"
#include "diagnostics/message.hpp"

#include <chrono>
#include <cstddef>
#include <vector>

namespace axisc::cli {

class Progress {
 public:
  /// Without `shown` nothing is ever written.
  Progress(bool shown, Language language) : shown_(shown), language_(language) {}
  Progress(Progress const&) = delete;
  Progress& operator=(Progress const&) = delete;
  /// Removes the line.
  ~Progress();

  /// At most ten times a second: a bar, percent, and the seconds of machine time.
  void show(double share, double seconds);
  /// At most ten times a second: a count and the rate per second. Nothing in the first half second, in which
  /// most runs end.
  void show(std::size_t done, std::size_t count);
  /// Removes the line before `console` prints, so that the two do not mix on a terminal, for as long as this
  /// object lives.
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
