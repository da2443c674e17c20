#include "analysis/motion/contour/contour_meter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace axisc::motion {

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
  ahead_ = static_cast<std::int64_t>((earliest + latest) / 2);
  from_ = static_cast<std::int64_t>(std::floor(earliest) - reach) - 1;
  to_ = static_cast<std::int64_t>(std::ceil(latest) + reach) + 1;
  auto const needed = static_cast<std::uint64_t>(to_ - std::min<std::int64_t>(from_, 0)) + reach_ + 4;
  setpoints_.assign(std::bit_ceil(needed), {});
  mask_ = setpoints_.size() - 1;
  path_.begin(setpoints_.size(), cycles_);
  // The rest before the first setpoint is one point of the path.
  path_.append(position);
  setpoints_[cycles_ & mask_] = {.nominal = position, .straight = 0, .direction = {}};
  ++cycles_;
}

void ContourMeter::cycle(ContourPoint point, Point const& filtered) {
  point.cycle = cycles_;
  pending_.push_back(point);
  pass(point.nominal, filtered);
}

void ContourMeter::pass(Point const& nominal, Point const& filtered) {
  Setpoint const& before = at(cycles_ - 1);
  Setpoint now{.nominal = nominal, .straight = 0, .direction = {}};
  Point const way = minus(nominal, before.nominal);
  if (double const distance = length(way); distance > 0) {
    now.direction = plus({}, 1 / distance, way);
    bool const goes_on = dot(now.direction, before.direction) > 1 - 1e-12;
    now.straight = goes_on ? before.straight + 1 : 1;
  }
  setpoints_[cycles_ & mask_] = now;
  path_.append(filtered);
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
  auto measured = look(point);
  if (!point.is_corner) measured.lag = lag_of(point);
  sink_.measured(measured);
}

MeasuredPoint ContourMeter::look(ContourPoint const& point) {
  auto const cycle = static_cast<std::int64_t>(point.cycle);
  auto const newest = static_cast<std::int64_t>(cycles_) - 1;
  auto const last = std::min(cycle + to_, newest);
  auto const first = std::min(std::max(cycle + from_, static_cast<std::int64_t>(path_.oldest())), last);
  auto const likely = std::clamp(cycle + ahead_, first, last);
  auto const found = path_.nearest(point.nominal, static_cast<std::uint64_t>(first),
                                   static_cast<std::uint64_t>(likely), static_cast<std::uint64_t>(last));
  ahead_ = static_cast<std::int64_t>(found.cycle) - cycle;
  MeasuredPoint measured{.point = point,
                         .filtered = path_.at(point.cycle),
                         .axis_error = found.point.away,
                         .deviation = found.point.distance(),
                         .lag = std::nullopt};
  for (auto& error : measured.axis_error) error = std::abs(error);
  return measured;
}

std::optional<double> ContourMeter::lag_of(ContourPoint const& point) const {
  if (!delay_ || point.cycle + *delay_ >= cycles_ || point.cycle + reach_ >= cycles_) return std::nullopt;
  // All setpoints that the kernel sees lie on one line, and moved.
  if (at(point.cycle + reach_).straight < 2 * reach_ + 1) return std::nullopt;
  return dot(minus(path_.at(point.cycle + *delay_), point.nominal), at(point.cycle).direction);
}

}  // namespace axisc::motion
