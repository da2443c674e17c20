#include "analysis/comparison/telling_motion.hpp"

#include "analysis/comparison/residual.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace axisc::comparison {

namespace {

/// Cycles at rest before a motion, more than the longest offset of columns.
constexpr std::size_t rest = 20;
/// Differences that are not this many times as large as the rounding are hidden by it.
constexpr double clearly = 3;

std::vector<double> setpoints(Motion motion, Motions const& motions, std::size_t settling) {
  std::size_t const moving = motion == Motion::step ? 0 : settling;
  std::vector<double> values(rest + moving + settling + rest, 0.0);
  for (std::size_t n = rest; n < values.size(); ++n) {
    values[n] = motion == Motion::step
                    ? motions.step
                    : motions.velocity * static_cast<double>(std::min(n - rest + 1, moving));
  }
  return values;
}

/// The residual between the answers of two readings, the second one taken for a recording, in cycles where it
/// moves.
double apart(Reading const& one, Reading const& other, std::vector<double> const& input, double resolution) {
  Recording const recording{
      .input = Signal(input), .output = Signal(respond(other.chain, input)), .gaps = {}};
  auto const counted = counted_cycles(recording, {.settling = 0, .output_resolution = resolution});
  // As in compare(), fractions of a cycle are only allowed for the listed chain.
  return one.departures.empty()
             ? residual_of(one.chain, recording, counted).rms
             : residual_of(respond(one.chain, input), recording.output.values(), counted).rms;
}

}  // namespace

std::optional<Motion> telling_motion(std::span<Reading const> readings, Comparison const& comparison,
                                     Motions const& motions) {
  if (readings.size() < 2) return std::nullopt;
  std::size_t settling = 0;
  for (auto const& reading : readings) settling = std::max(settling, settling_cycles(reading.chain));
  for (auto const motion : {Motion::velocity_jump, Motion::step}) {
    auto const input = setpoints(motion, motions, settling);
    bool tells = true;
    for (std::size_t i = 0; i < readings.size() && tells; ++i) {
      for (std::size_t k = i + 1; k < readings.size() && tells; ++k) {
        tells = apart(readings[i], readings[k], input, comparison.output_resolution) >
                clearly * comparison.allowed_rms;
      }
    }
    if (tells) return motion;
  }
  return Motion::none;
}

}  // namespace axisc::comparison
