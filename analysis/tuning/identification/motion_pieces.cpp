#include "analysis/tuning/identification/motion_pieces.hpp"

#include "analysis/tuning/identification/thresholds.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::tuning {
namespace {

/// Of the whole way of the setpoint: less is not a motion, much less is rest.
constexpr double least_motion = 0.01;
constexpr double resting = 1e-5;
/// Half of the 20 ms over which a speed is taken.
constexpr double half_span = 0.01;

double way(std::span<double const> values) {
  if (values.empty()) return 0;
  auto const [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

/// Runs whose values stay within `tolerance` of their first one, after a motion. A velocity rests at 0.
std::vector<Piece> rests_of(std::span<double const> setpoint, double sampling_rate, InputKind kind) {
  double const whole = way(setpoint);
  double const tolerance = resting * whole;
  auto const shortest =
      std::max(fewest_rest_samples, static_cast<std::size_t>(std::ceil(shortest_rest * sampling_rate)));
  std::vector<Piece> rests;
  if (!(whole > 0)) return rests;
  std::size_t moved_from = 0;
  for (std::size_t first = 0; first < setpoint.size();) {
    std::size_t end = first + 1;
    while (end < setpoint.size() && std::abs(setpoint[end] - setpoint[first]) <= tolerance) ++end;
    if (end - first < shortest) {
      ++first;
      continue;
    }
    bool const can_rest = kind != InputKind::velocity || std::abs(setpoint[first]) <= tolerance;
    if (can_rest && first > 0 &&
        way(setpoint.subspan(moved_from, first - moved_from + 1)) >= least_motion * whole) {
      rests.push_back({.first = first, .count = end - first});
    }
    moved_from = end - 1;
    first = end;
  }
  return rests;
}

/// Units a second, over 20 ms; positions only.
std::vector<double> speeds_of(std::span<double const> setpoint, double sampling_rate, InputKind kind) {
  std::vector<double> speeds(setpoint.begin(), setpoint.end());
  if (kind == InputKind::velocity) return speeds;
  auto const half =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(half_span * sampling_rate)));
  std::fill(speeds.begin(), speeds.end(), 0.0);
  for (std::size_t n = half; n + half < setpoint.size(); ++n) {
    speeds[n] = (setpoint[n + half] - setpoint[n - half]) * sampling_rate / (2 * static_cast<double>(half));
  }
  return speeds;
}

std::vector<Piece> constant_pieces(std::vector<double> const& speeds, double sampling_rate) {
  double highest = 0;
  for (double const speed : speeds) highest = std::max(highest, std::abs(speed));
  auto const shortest =
      std::max(fewest_piece_samples, static_cast<std::size_t>(std::ceil(shortest_piece * sampling_rate)));
  std::vector<Piece> pieces;
  for (std::size_t first = 0; first < speeds.size();) {
    std::size_t end = first;
    double sum = 0, low = speeds[first], high = speeds[first];
    while (end < speeds.size()) {
      low = std::min(low, speeds[end]);
      high = std::max(high, speeds[end]);
      double const mean = (sum + speeds[end]) / static_cast<double>(end - first + 1);
      if (high - low > 2 * constant_speed * std::abs(mean)) break;
      sum += speeds[end];
      ++end;
    }
    std::size_t const count = end - first;
    double const speed = count > 0 ? std::abs(sum) / static_cast<double>(count) : 0;
    bool const counts = count >= shortest && speed > 0 && speed >= slowest_share * highest;
    if (counts) pieces.push_back({.first = first, .count = count, .speed = speed});
    // Runs that are too short overlap with the next one; long ones that do not count are at rest.
    constexpr std::size_t overlap = 16;
    first = count >= shortest ? end : first + std::max<std::size_t>(1, count / overlap);
  }
  return pieces;
}

}  // namespace

MotionPieces motion_pieces(std::span<double const> setpoint, double sampling_rate, InputKind kind) {
  if (kind == InputKind::force || setpoint.empty()) return {};
  return {.rests = rests_of(setpoint, sampling_rate, kind),
          .constant = constant_pieces(speeds_of(setpoint, sampling_rate, kind), sampling_rate)};
}

}  // namespace axisc::tuning
