#include "motion/contour_meter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace axisc::motion {
namespace {

/// Position units: sums of the steps of a path of hundreds of metres.
constexpr double rounding_of_ways = 1e-3;

/// The vector from `p` to the nearest point of a line a..b, where it is shorter than the best so far.
void consider(Point const& p, Point const& a, Point const& b, std::size_t axes, double& squared,
              Point& away) {
  double along = 0;
  double length = 0;
  double start = 0;
  for (std::size_t i = 0; i < axes; ++i) {
    double const d = b[i] - a[i];
    double const f = a[i] - p[i];
    along += d * f;
    length += d * d;
    start += f * f;
  }
  double share = 0;
  double here = start;
  if (along < 0) {
    share = std::min(1.0, -along / length);
    here = start + share * (2 * along + share * length);
  }
  // The sum above cancels next to 0: only what may be nearer is computed exactly.
  if (here > squared + 1e-9 * start) return;
  Point vector{};
  double exact = 0;
  for (std::size_t i = 0; i < axes; ++i) {
    vector[i] = share < 1 ? (a[i] - p[i]) + share * (b[i] - a[i]) : b[i] - p[i];
    exact += vector[i] * vector[i];
  }
  if (exact >= squared) return;
  squared = exact;
  away = vector;
}

double distance(Point const& a, Point const& b, std::size_t axes) {
  double squared = 0;
  for (std::size_t i = 0; i < axes; ++i) squared += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squared);
}

/// The first number from `begin` on for which this holds, as it does for all behind it; `end` where there is none. Most
/// are next to `begin`, or there is none.
template <typename Holds>
std::int64_t first_where(std::int64_t begin, std::int64_t end, Holds holds) {
  if (begin >= end || holds(begin)) return begin;
  if (!holds(end - 1)) return end;
  while (!holds(++begin)) {
  }
  return begin;
}

}  // namespace

void ContourMeter::begin(std::span<ChainAnswer const> answers, Point const& position) {
  double earliest = std::numeric_limits<double>::infinity();
  double latest = 0;
  double reach = 0;
  bool only_delays = true;
  for (auto const& answer : answers) {
    earliest = std::min(earliest, answer.delay);
    latest = std::max(latest, answer.delay);
    reach = std::max(reach, answer.reach);
    only_delays = only_delays && answer.only_delays();
  }
  bool const whole = earliest == latest && earliest == std::floor(earliest);
  alike_delays_ = only_delays && earliest == latest;
  delay_ = whole ? std::optional(static_cast<std::uint64_t>(earliest)) : std::nullopt;
  reach = std::min(reach, longest_reach);
  reach_ = static_cast<std::uint64_t>(reach);
  middle_ = static_cast<std::int64_t>((earliest + latest) / 2);
  from_ = static_cast<std::int64_t>(std::floor(earliest) - reach) - 1;
  to_ = static_cast<std::int64_t>(std::ceil(latest) + reach) + 1;
  auto const needed = static_cast<std::uint64_t>(to_ - std::min<std::int64_t>(from_, 0)) + reach_ + 4;
  passed_.assign(std::bit_ceil(needed), {});
  mask_ = passed_.size() - 1;
  // The rest before the first setpoint is one point of the path.
  Passed const rest{.filtered = position, .way = 0, .nominal = position, .straight = 0, .direction = {}};
  first_ = cycles_;
  passed_[cycles_ & mask_] = rest;
  ++cycles_;
}

void ContourMeter::cycle(ContourPoint point, Point const& filtered) {
  point.cycle = cycles_;
  pending_.push_back(point);
  pass(point.nominal, filtered);
}

void ContourMeter::pass(Point const& nominal, Point const& filtered) {
  Passed const& before = at(cycles_ - 1);
  Passed now{.filtered = filtered,
             .way = before.way + distance(filtered, before.filtered, axes_),
             .nominal = nominal,
             .straight = 0,
             .direction = {}};
  Point const way = minus(nominal, before.nominal);
  if (double const distance = length(way); distance > 0) {
    now.direction = plus({}, 1 / distance, way);
    bool const goes_on = dot(now.direction, before.direction) > 1 - 1e-12;
    now.straight = goes_on ? before.straight + 1 : 1;
  }
  passed_[cycles_ & mask_] = now;
  ++cycles_;
  while (!pending_.empty() &&
         static_cast<std::int64_t>(pending_.front().cycle) + to_ < static_cast<std::int64_t>(cycles_)) {
    measure(pending_.front());
    pending_.pop_front();
  }
}

void ContourMeter::corner(ContourPoint point) {
  if (alike_delays_) return;
  point.is_corner = true;
  point.cycle = cycles_ - 1;
  pending_.push_back(point);
}

void ContourMeter::finish() {
  for (auto const& point : pending_) measure(point);
  pending_.clear();
}

void ContourMeter::measure(ContourPoint const& point) {
  auto const cycle = static_cast<std::int64_t>(point.cycle);
  auto const oldest =
      std::max(static_cast<std::int64_t>(first_), static_cast<std::int64_t>(cycles_ - passed_.size()));
  auto const newest = static_cast<std::int64_t>(cycles_) - 1;
  auto const first = std::min(std::max(cycle + from_, oldest), newest);
  auto const last = std::min(cycle + to_, newest);
  double squared = std::numeric_limits<double>::infinity();
  Point away{};
  if (first == last) {
    auto const& only = at(static_cast<std::uint64_t>(first)).filtered;
    consider(point.nominal, only, only, axes_, squared, away);
  }
  // Away from the middle to either side; what lies so far along the path that it cannot be nearer is left out.
  auto const passed = [&](std::int64_t n) -> Passed const& { return at(static_cast<std::uint64_t>(n)); };
  auto const spare = [&](Passed const& from) {
    return distance(from.filtered, point.nominal, axes_) - std::sqrt(squared) - rounding_of_ways;
  };
  auto const middle = std::clamp(cycle + middle_, first, last);
  for (auto n = middle; n < last;) {
    auto const& end = passed(n + 1);
    consider(point.nominal, passed(n).filtered, end.filtered, axes_, squared, away);
    double const out_of_reach = end.way + spare(end);
    n = first_where(n + 1, last, [&](std::int64_t m) { return passed(m + 1).way >= out_of_reach; });
  }
  for (auto n = middle; n > first;) {
    auto const& end = passed(n - 1);
    consider(point.nominal, end.filtered, passed(n).filtered, axes_, squared, away);
    double const out_of_reach = end.way - spare(end);
    n = -first_where(1 - n, -first, [&](std::int64_t m) { return passed(-m - 1).way <= out_of_reach; });
  }
  MeasuredPoint measured{.point = point,
                         .filtered = at(point.cycle).filtered,
                         .axis_error = away,
                         .deviation = std::sqrt(squared),
                         .lag = point.is_corner ? std::nullopt : lag_of(point)};
  for (auto& error : measured.axis_error) error = std::abs(error);
  sink_.measured(measured);
}

std::optional<double> ContourMeter::lag_of(ContourPoint const& point) const {
  if (!delay_ || point.cycle + *delay_ >= cycles_ || point.cycle + reach_ >= cycles_) return std::nullopt;
  // All setpoints that the kernel sees lie on one line, and moved.
  if (at(point.cycle + reach_).straight < 2 * reach_ + 1) return std::nullopt;
  return dot(minus(at(point.cycle + *delay_).filtered, point.nominal), at(point.cycle).direction);
}

}  // namespace axisc::motion
