#include "cli/terminal/progress.hpp"

#include "diagnostics/format_number.hpp"
#include "system/process.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace axisc::cli::says {

constexpr Sentence simulate_progress{"{percent} % of the program, {time} s simulated",
                                     "{percent} % des Programms, {time} s simuliert"};

constexpr Sentence progress{"{done} of {count}, {rate} per second", "{done} von {count}, {rate} je Sekunde"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr std::size_t bar_width = 30;
constexpr std::chrono::milliseconds pause{100};
constexpr std::chrono::milliseconds patience{500};

}  // namespace

Progress::~Progress() {
  hide();
  for (auto* const console : consoles_) console->before_printing({});
}

void Progress::hide() {
  if (std::exchange(written_, false)) static_cast<void>(system::write(system::Stream::error, "\r\033[K"));
}

void Progress::stand_aside_for(Console& console) {
  if (!shown_) return;
  console.before_printing([this] { hide(); });
  consoles_.push_back(&console);
}

bool Progress::is_due() {
  if (!shown_) return false;
  auto const now = std::chrono::steady_clock::now();
  if (now - last_ < pause) return false;
  last_ = now;
  return true;
}

void Progress::show(double share, double seconds) {
  if (!is_due()) return;
  draw(share, {says::simulate_progress,
               {{"percent", fmt::format("{:.0f}", share * 100)}, {"time", format_fixed(seconds, 1)}}});
}

void Progress::show(std::size_t done, std::size_t count) {
  if (!is_due()) return;
  std::chrono::duration<double> const seconds = last_ - begun_;
  if (seconds < patience) return;
  draw(static_cast<double>(done) / static_cast<double>(count),
       {says::progress,
        {{"done", std::to_string(done)},
         {"count", std::to_string(count)},
         {"rate", fmt::format("{:.0f}", static_cast<double>(done) / seconds.count())}}});
}

void Progress::draw(double share, Message const& message) {
  written_ = true;
  auto const filled = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * bar_width);
  std::string const bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
  static_cast<void>(
      system::write(system::Stream::error, "\r[" + bar + "] " + render(message, language_) + "\033[K"));
}

bool progress_is_seen() {
  return system::is_terminal(system::Stream::error);
}

}  // namespace axisc::cli
