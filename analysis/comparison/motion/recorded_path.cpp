#include "analysis/comparison/motion/recorded_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace axisc::comparison {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
/// Beyond half of a step, as for filters.
constexpr double own_errors = 1.05;
/// Of the largest position: doubles of another program.
constexpr double numeric_noise = 2e-9;
/// Offsets beyond those at which a plan begins to move in time.
constexpr std::ptrdiff_t margin = 2;

using Offset = std::ptrdiff_t;

class Fitting {
 public:
  Fitting(std::span<motion::Point const> plan, RecordedPath const& path, Stretch const& moving,
          Stretch const& free)
      : plan_(plan), path_(path), moving_(moving), free_(free), last_(static_cast<Offset>(plan.size()) - 1) {}

  Deviation best() {
    auto const begin = static_cast<Offset>(moving_.begin);
    auto const end = static_cast<Offset>(moving_.end);
    for (Offset at = begin + margin; at >= begin + 1 - first_visible() - margin; --at) take(at, best_.excess);
    if (best_.fits()) return best_;
    descend((begin + end - last_) / 2);
    descend(end - last_);
    return best_;
  }

 private:
  /// The first cycle of the plan that a recording shows, whatever the constant.
  [[nodiscard]] Offset first_visible() const {
    for (Offset k = 1; k <= last_; ++k) {
      for (auto const& position : path_.positions) {
        auto const axis = position.axis;
        double const way = std::abs(plan_[static_cast<std::size_t>(k)][axis] - plan_.front()[axis]);
        if (way >= position.resolution) return k;
      }
    }
    return last_;
  }

  /// Lower offsets and higher ones as long as they fit better.
  void descend(Offset from) {
    double here = take(from, unlimited);
    for (Offset const step : {-1, 1}) {
      for (Offset at = from + step;; at += step) {
        double const next = take(at, unlimited);
        if (!(next < here)) break;
        here = next;
      }
    }
  }

  double take(Offset at, double limit) {
    auto const found = deviation_at(at, limit);
    if (found.excess < best_.excess) best_ = found;
    return found.excess;
  }

  /// The plan's first setpoint is that of this cycle of the recording. Above the limit the excess is not
  /// computed: infinite.
  [[nodiscard]] Deviation deviation_at(Offset at, double limit) const {
    auto const size = static_cast<Offset>(path_.size());
    // What a recording does not contain cannot be compared; what lies in another move does not fit.
    if (at < static_cast<Offset>(free_.begin) && free_.begin > 0) return {.excess = unlimited};
    if (at + last_ > static_cast<Offset>(free_.end) && static_cast<Offset>(free_.end) + 1 < size) {
      return {.excess = unlimited};
    }
    auto const from = std::max<Offset>(std::min<Offset>(at, static_cast<Offset>(moving_.begin)), 0);
    auto const to = std::min(std::max(at + last_, static_cast<Offset>(moving_.end)), size - 1);
    Deviation whole;
    for (auto const& position : path_.positions) {
      double lowest = unlimited;
      double highest = -unlimited;
      double sum = 0;
      double square_sum = 0;
      std::size_t count = 0;
      // Relative to the beginning: sums of squares stay exact enough.
      double const origin = position.values[moving_.begin] - plan_.front()[position.axis];
      for (Offset cycle = from; cycle <= to; ++cycle) {
        auto const now = static_cast<std::size_t>(cycle);
        if (!path_.counts(now)) continue;
        auto const k = static_cast<std::size_t>(std::clamp<Offset>(cycle - at, 0, last_));
        double const difference = position.values[now] - plan_[k][position.axis] - origin;
        lowest = std::min(lowest, difference);
        highest = std::max(highest, difference);
        if (highest - lowest > 2 * position.allowed * limit) return {.excess = unlimited};
        sum += difference;
        square_sum += difference * difference;
        ++count;
      }
      if (count == 0) continue;
      double const largest = (highest - lowest) / 2;
      double const mean = sum / static_cast<double>(count);
      whole.add({.largest = largest,
                 .square_sum = std::max(0.0, square_sum - mean * sum),
                 .count = count,
                 .excess = largest / position.allowed});
    }
    return whole;
  }

  std::span<motion::Point const> plan_;
  RecordedPath const& path_;
  Stretch moving_, free_;
  Offset last_;
  Deviation best_{.excess = unlimited};
};

}  // namespace

double Deviation::rms() const {
  return count == 0 ? 0 : std::sqrt(square_sum / static_cast<double>(count));
}

void Deviation::add(Deviation const& other) {
  largest = std::max(largest, other.largest);
  square_sum += other.square_sum;
  count += other.count;
  excess = std::max(excess, other.excess);
}

RecordedPosition recorded_position(std::size_t axis, std::vector<double> values, double resolution) {
  double largest = 1;
  for (double const value : values) largest = std::max(largest, std::abs(value));
  return {.axis = axis,
          .values = std::move(values),
          .resolution = resolution,
          .allowed = own_errors * resolution / 2 + numeric_noise * largest};
}

std::vector<Stretch> moving_stretches(RecordedPath const& path, std::size_t rest) {
  std::vector<Stretch> stretches;
  for (std::size_t cycle = 1; cycle < path.size(); ++cycle) {
    bool const moves =
        std::any_of(path.positions.begin(), path.positions.end(), [cycle](RecordedPosition const& position) {
          return position.values[cycle] != position.values[cycle - 1];
        });
    if (!moves) continue;
    bool const goes_on = !stretches.empty() && cycle - stretches.back().end < rest;
    if (!goes_on) stretches.push_back({.begin = cycle - 1, .end = cycle});
    stretches.back().end = cycle;
  }
  return stretches;
}

Deviation deviation_of(std::span<motion::Point const> plan, RecordedPath const& path, Stretch const& moving,
                       Stretch const& free) {
  return Fitting(plan, path, moving, free).best();
}

}  // namespace axisc::comparison
