#include "motion/tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axisc::motion {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
/// The probe looks at a few phases only; between them the error may be this much larger.
constexpr double between_phases = 1.004;
/// The same where corners stand so close that no probe of one of them tells.
constexpr double among_others = 1.02;
constexpr std::size_t remembered = 64;

bool alike(Corner const& a, Corner const& b) {
  auto const close = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::abs(x); };
  Point const before = minus(a.before, b.before);
  Point const turn = minus(a.turn, b.turn);
  return dot(before, before) < 1e-18 && dot(turn, turn) < 1e-18 &&
         close(a.velocity_before, b.velocity_before) && close(a.velocity_behind, b.velocity_behind) &&
         close(a.acceleration_before, b.acceleration_before) &&
         close(a.acceleration_behind, b.acceleration_behind);
}

}  // namespace

ToleranceMonitor::ToleranceMonitor(GroupRuntime& probe, std::vector<ChainAnswer> const& answers,
                                   double tolerance) {
  for (auto const& answer : answers) reach_ = std::max(reach_, answer.reach);
  if (reach_ == 0) return;
  answers_ = answers;
  tolerance_ = tolerance;
  probe_.emplace(probe, answers_);
}

double ToleranceMonitor::at_corner(Corner const& corner) const {
  double largest = 0;
  for (std::size_t i = 0; i < answers_.size(); ++i) {
    largest = std::max(largest, std::abs(corner.turn[i] * answers_[i].corner));
  }
  return largest;
}

double ToleranceMonitor::enlarged(Corner const& corner) {
  for (auto const& known : known_) {
    if (alike(known.corner, corner)) return known.enlarged;
  }
  double const alone = at_corner(corner);
  if (!(alone > 0)) return 1;
  double ratio = 1;
  // The share of the ramps depends on the velocity, but not much: it settles at once.
  for (int const phases : {4, 8}) {
    double const plateau = tolerance_ / (alone * ratio);
    double const error = probe_->largest_axis_error(corner, plateau, phases);
    ratio = std::max(1.0, error / (plateau * alone)) * between_phases;
  }
  if (known_.size() < remembered) known_.emplace_back();
  known_[replaced_] = {.corner = corner, .enlarged = ratio};
  replaced_ = (replaced_ + 1) % remembered;
  return ratio;
}

double ToleranceMonitor::largest_error(std::span<Corner const> near, std::size_t index,
                                       double velocity) const {
  Point sum{};
  for (std::size_t i = 0; i < answers_.size(); ++i) sum[i] = near[index].turn[i] * answers_[i].corner;
  auto const add = [&](Corner const& corner) {
    double const cycles = (near[index].place - corner.place) / velocity;
    if (std::abs(cycles) >= reach_) return false;
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      sum[i] += corner.turn[i] * answers_[i].remainder(cycles);
    }
    return true;
  };
  for (std::size_t m = index; m > 0 && add(near[m - 1]);) --m;
  for (std::size_t m = index + 1; m < near.size() && add(near[m]);) ++m;
  double largest = 0;
  for (double const error : sum) largest = std::max(largest, std::abs(error));
  return velocity * largest;
}

double ToleranceMonitor::velocity(std::span<Corner const> corners, std::size_t index) {
  double const fastest = std::max(corners[index].velocity_before, corners[index].velocity_behind);
  double const horizon = fastest * reach_;
  std::size_t first = index;
  std::size_t last = index;
  while (first > 0 && index - first < most_neighbours &&
         corners[index].place - corners[first - 1].place < horizon) {
    --first;
  }
  while (last + 1 < corners.size() && last - index < most_neighbours &&
         corners[last + 1].place - corners[index].place < horizon) {
    ++last;
  }
  auto const near = corners.subspan(first, last - first + 1);

  // No velocity up to this one can reach the tolerance: all corners together, each at its worst, and beside a corner no
  // axis is twice as far away as at it.
  double worst = 0;
  for (std::size_t i = 0; i < answers_.size(); ++i) {
    double sum = 0;
    for (auto const& corner : near) sum += std::abs(corner.turn[i]);
    worst = std::max(worst, sum * std::abs(answers_[i].corner));
  }
  if (!(worst > 0) || tolerance_ / worst >= 2 * fastest) return unlimited;
  double const tolerance = tolerance_ / among_others;
  double low = tolerance / worst;
  double high = low;
  do {
    if (high >= fastest) return unlimited;
    low = high;
    high = std::min(high * 1.1, fastest);
  } while (largest_error(near, index - first, high) <= tolerance);
  for (int i = 0; i < 30; ++i) {
    double const middle = (low + high) / 2;
    (largest_error(near, index - first, middle) <= tolerance ? low : high) = middle;
  }
  double const reached = low * plateau();
  bool const others = (index > first && corners[index].place - corners[index - 1].place < reached) ||
                      (index < last && corners[index + 1].place - corners[index].place < reached);
  if (!others) low = std::min(low * among_others / enlarged(corners[index]), fastest);
  return low;
}

}  // namespace axisc::motion
