#include "analysis/tuning/rigid_model/motion_windows.hpp"

#include "analysis/motion/statistics.hpp"
#include "analysis/tuning/rigid_model/thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace axisc::tuning {

namespace {

/// Over 2 half_speed_span; 0 at the ends.
std::vector<double> speeds_of(std::span<double const> position, double T) {
  auto const half = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(half_speed_span / T)));
  std::vector<double> speeds(position.size(), 0.0);
  for (std::size_t k = half; k + half < position.size(); ++k) {
    speeds[k] = (position[k + half] - position[k - half]) / (2 * static_cast<double>(half) * T);
  }
  return speeds;
}

/// x(k-2) - 4 x(k-1) + 6 x(k) - 4 x(k+1) + x(k+2)
double fourth_difference(std::span<double const> x, std::size_t k) {
  return x[k - 2] - 4 * x[k - 1] + 6 * x[k] - 4 * x[k + 1] + x[k + 2];
}

}  // namespace

Directions::Directions(std::span<MotionRecord const> records, double T) {
  std::vector<std::vector<double>> speeds;
  double highest = 0;
  for (auto const& record : records) {
    speeds.push_back(speeds_of(record.position, T));
    for (double const speed : speeds.back()) highest = std::max(highest, std::abs(speed));
  }
  double const slowest = slowest_motion * highest;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    auto const size = speeds[r].size();
    auto& counts = counts_.emplace_back();
    counts.forwards.assign(size + 1, 0);
    counts.backwards.assign(size + 1, 0);
    for (std::size_t k = 0; k < size; ++k) {
      double const speed = speeds[r][k];
      counts.forwards[k + 1] = counts.forwards[k] + (speed > slowest ? 1 : 0);
      counts.backwards[k + 1] = counts.backwards[k] + (speed < -slowest ? 1 : 0);
      if (!(std::abs(speed) > slowest) || k < 2 || k + 2 >= size) continue;
      double const difference = fourth_difference(records[r].position, k);
      sum += difference * difference;
      ++count;
    }
    forwards_ += counts.forwards.back();
    backwards_ += counts.backwards.back();
  }
  // 1 + 16 + 36 + 16 + 1: the variance of a fourth difference of white noise.
  constexpr double gain = 70;
  if (count > 0) noise_ = std::sqrt(sum / static_cast<double>(count) / gain);
}

int Directions::of(std::size_t record, std::size_t first, std::size_t count) const {
  auto const& counts = counts_[record];
  auto const moves = [&](std::vector<std::uint32_t> const& sums) {
    return sums[first + count] - sums[first] == count;
  };
  return moves(counts.forwards) ? 1 : moves(counts.backwards) ? -1 : 0;
}

std::vector<WindowMotion> motion_windows(std::span<MotionRecord const> records, Directions const& directions,
                                         Window const& window) {
  auto const length = window.length();
  std::size_t const hop = std::max<std::size_t>(1, length / windows_per_length);
  constexpr std::size_t before = window_margin;
  constexpr std::size_t after = std::max<std::size_t>(window_margin, latest_force);
  std::vector<WindowMotion> found;
  for (std::size_t r = 0; r < records.size(); ++r) {
    std::span<double const> const position = records[r].position;
    for (std::size_t first = before; first + length + after <= position.size(); first += hop) {
      int const direction = directions.of(r, first, length);
      if (direction == 0) continue;
      auto const near = position.subspan(first - window_margin, length + 2 * window_margin);
      found.push_back({.record = r,
                       .first = first,
                       .velocity = derivative_at(window.velocity, near),
                       .acceleration = derivative_at(window.acceleration, near),
                       .fourth = derivative_at(window.fourth, near),
                       .direction = direction});
    }
  }
  return found;
}

double window_force(MotionRecord const& record, std::size_t first, int dead_time, Window const& window) {
  auto const begin = static_cast<std::ptrdiff_t>(first) + dead_time;
  return std::inner_product(window.weights.begin(), window.weights.end(), record.force.begin() + begin, 0.0);
}

double noise_share(std::span<MotionRecord const> records, std::span<double const> weights, double noise) {
  std::size_t const hop = std::max<std::size_t>(1, weights.size() / windows_per_length);
  std::vector<double> measured;
  for (auto const& record : records) {
    std::span<double const> const position = record.position;
    for (std::size_t first = 0; first + weights.size() <= position.size(); first += hop) {
      measured.push_back(derivative_at(weights, position.subspan(first, weights.size())));
    }
  }
  if (measured.empty()) return 1;
  double const variance = motion::variance(measured);
  if (!(variance > 0)) return 1;
  double const gain = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
  return noise * noise * gain / variance;
}

}  // namespace axisc::tuning
