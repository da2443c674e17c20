#include "analysis/comparison/overlay.hpp"

#include "analysis/comparison/liveliness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axisc::comparison {

Overlay overlay(Recording const& recording, Chain const& chain, double delay_cycles, std::size_t cycles) {
  std::size_t const size = recording.input.size();
  Overlay shown{
      .first = liveliest_part(recording.input, cycles), .input = {}, .recorded = {}, .computed = {}};
  std::size_t const length = std::min(cycles, size - shown.first);
  shown.input.resize(length);
  shown.recorded.resize(length);
  recording.input.read(shown.first, shown.input);
  recording.output.read(shown.first, shown.recorded);

  // The chain's answer at n - delay lies between two cycles.
  double const whole = std::floor(delay_cycles);
  double const part = delay_cycles - whole;
  auto const lag = static_cast<std::ptrdiff_t>(whole);
  auto const begin = static_cast<std::ptrdiff_t>(shown.first) - lag - 1;
  std::vector<double> answers(length + 1, std::numeric_limits<double>::quiet_NaN());
  Runner runner(chain, recording.first);
  std::vector<double> piece;
  for_each_part(recording.input, [&](std::size_t first, std::span<double const> input) {
    piece.assign(input.begin(), input.end());
    runner.run(piece);
    auto const offset = static_cast<std::ptrdiff_t>(first) - begin;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      auto const at = offset + static_cast<std::ptrdiff_t>(i);
      if (at >= 0 && at < static_cast<std::ptrdiff_t>(answers.size())) {
        answers[static_cast<std::size_t>(at)] = piece[i];
      }
    }
  });
  for (std::size_t i = 0; i < length; ++i) {
    shown.computed.push_back(part == 0 ? answers[i + 1]
                                       : answers[i + 1] + part * (answers[i] - answers[i + 1]));
  }
  return shown;
}

}  // namespace axisc::comparison
