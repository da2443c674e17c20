#include "cli/progress.hpp"

#include "cli/file_descriptor.hpp"

#include <algorithm>
#include <unistd.h>

#include <fmt/format.h>

namespace axisc::cli {

namespace {

constexpr std::size_t bar_width = 30;
constexpr std::chrono::milliseconds pause{100};

}  // namespace

Progress::~Progress() {
  if (written_) static_cast<void>(write_all(2, "\r\033[K"));
}

void Progress::show(double share, double seconds) {
  if (!shown_) return;
  auto const now = std::chrono::steady_clock::now();
  if (written_ && now - last_ < pause) return;
  last_ = now;
  written_ = true;
  share = std::clamp(share, 0.0, 1.0);
  auto const filled = static_cast<std::size_t>(share * bar_width);
  std::string const bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
  static_cast<void>(write_all(2, "\r[" + bar + "] " +
                                     render({.text = Text::simulate_progress,
                                             .arguments = {{"percent", fmt::format("{:.0f}", share * 100)},
                                                           {"time", fmt::format("{:.1f}", seconds)}}},
                                            language_)));
}

bool progress_is_seen() {
  return ::isatty(2) != 0;
}

}  // namespace axisc::cli
