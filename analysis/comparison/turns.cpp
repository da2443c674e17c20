#include "analysis/comparison/turns.hpp"

#include <cmath>

namespace axisc::comparison {

namespace {

struct Unwound {
  Signal signal;
  std::size_t jumps = 0;
};

Unwound unwound(Signal const& signal, std::vector<std::size_t> const& gaps, double turn) {
  Unwound made;
  double turns = 0;
  double last = 0;
  std::size_t missing = 0;
  auto gap = gaps.begin();
  for_each_part(signal, [&](std::size_t first, std::span<double const> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (gap != gaps.end() && *gap == first + i) {
        ++gap;
        ++missing;
        continue;
      }
      double const moved = made.signal.size() == 0 ? 0 : std::round((values[i] + turns * turn - last) / turn);
      if (moved != 0) ++made.jumps;
      turns -= moved;
      double const value = values[i] + turns * turn;
      for (std::size_t k = 1; k <= missing; ++k) {
        made.signal.push(last + (value - last) * static_cast<double>(k) / static_cast<double>(missing + 1));
      }
      missing = 0;
      made.signal.push(value);
      last = value;
    }
  });
  return made;
}

}  // namespace

std::size_t unwind(Recording& recording, double turn) {
  auto input = unwound(recording.input, recording.gaps, turn);
  auto output = unwound(recording.output, recording.gaps, turn);
  std::size_t const jumps = input.jumps + output.jumps;
  if (jumps == 0) return 0;
  // Both begin within the same turn, perhaps on either side of a jump.
  double const apart = std::round((recording.output.front() - recording.input.front()) / turn) * turn;
  recording.input = std::move(input.signal);
  if (apart == 0) {
    recording.output = std::move(output.signal);
    return jumps;
  }
  Signal moved;
  for_each_part(output.signal, [&](std::size_t, std::span<double const> values) {
    for (double const value : values) moved.push(value - apart);
  });
  recording.output = std::move(moved);
  return jumps;
}

std::size_t unwind(Signal& signal, std::vector<std::size_t> const& gaps, double turn) {
  auto found = unwound(signal, gaps, turn);
  if (found.jumps > 0) signal = std::move(found.signal);
  return found.jumps;
}

}  // namespace axisc::comparison
