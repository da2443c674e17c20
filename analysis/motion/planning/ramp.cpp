#include "analysis/motion/planning/ramp.hpp"

#include "analysis/motion/limited_by.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace axisc::motion {
namespace {

constexpr double pi_squared = std::numbers::pi * std::numbers::pi;
/// Bits of a double, and some.
constexpr int halvings = 80;
constexpr int most_root_steps = 60;
constexpr double last_root_step = 4e-6;
/// Times this near to a whole cycle are it.
constexpr double whole = 1e-9;

/// Root of f(q) = A q³ + B q - L with A, B ≥ 0, by Halley's method: each step leaves the cube of its share as
/// error.
double cubic_root(double A, double B, double L, double q) {
  for (int i = 0; i < most_root_steps; ++i) {
    double const square = A * q * q;
    double const f = q * (square + B) - L;
    double const slope = 3 * square + B;
    double const step = f * slope / (slope * slope - 3 * A * q * f);
    q -= step;
    if (std::abs(step) < last_root_step * q) break;
  }
  return q;
}

double whole_cycles(double time) {
  return time > 0 ? std::max(1.0, std::ceil(time - whole)) : 0;
}

}  // namespace

Ramp::Ramp(RampTimes const& times, RampRules const& rules)
    : times_(times),
      rules_(rules),
      c1_(rules.sine ? 0.25 - 1 / pi_squared : 1.0 / 6),
      c2_(rules.sine ? 0.25 + 1 / pi_squared : 1.0 / 3) {
  if (rules_.whole_change) {
    times_.at_slow_end = times_.at_fast_end = (times.at_slow_end + times.at_fast_end) / 2;
  }
  double const s = times_.at_slow_end;
  double const f = times_.at_fast_end;
  cubic_ = times_.acceleration * (c1_ * s * s + s * f / 2 + c2_ * f * f);
  change_time_ = s + f;
  half_change_ = times_.acceleration * change_time_ / 2;
  closed_ = !rules.constant_times && !rules.whole_cycles && cubic_ > 0;
}

Ramp::Ramp(std::array<AccelerationStep, most_axes + 1> const& steps, std::size_t count, bool whole_cycles)
    : rules_{.whole_cycles = whole_cycles}, steps_(steps), count_(count) {}

template <class Take>
void Ramp::for_each_step(double slow, double fast, Take take) const {
  for (std::size_t i = 0; i < count_; ++i) {
    double const from = std::max(slow, steps_[i].above);
    double const to = i + 1 < count_ ? std::min(fast, steps_[i + 1].above) : fast;
    if (!(from < to)) continue;
    double a = steps_[i].acceleration;
    if (rules_.whole_cycles) a = (to - from) / whole_cycles((to - from) / a);
    take(from, to, a);
  }
}

Ramp::Course Ramp::course(double change) const {
  double const a = times_.acceleration;
  double const both = times_.at_slow_end + times_.at_fast_end;
  Course course{.peak = a, .slow_end = times_.at_slow_end, .held = 0, .fast_end = times_.at_fast_end};
  if (2 * change >= a * both) {
    course.held = change / a - both / 2;
    if (rules_.whole_change) course = {.peak = a, .slow_end = change / a, .held = 0, .fast_end = change / a};
  } else if (rules_.constant_times) {
    course.peak = 2 * change / both;
  } else {
    double const q = std::sqrt(2 * change / (a * both));
    course = {.peak = q * a, .slow_end = q * course.slow_end, .held = 0, .fast_end = q * course.fast_end};
  }
  if (!rules_.whole_cycles) return course;
  course.slow_end = whole_cycles(course.slow_end);
  // A peak that is just reached is not held: rounding makes no cycle of it.
  course.held = course.held > whole ? whole_cycles(course.held) : 0;
  course.fast_end = whole_cycles(course.fast_end);
  course.peak = change / ((course.slow_end + course.fast_end) / 2 + course.held);
  return course;
}

double Ramp::way_of(Course const& course, double slow) const {
  double const s = course.slow_end;
  double const f = course.fast_end;
  double const h = course.held;
  return slow * course.time() +
         course.peak * (c1_ * s * s + s * h / 2 + h * h / 2 + (s / 2 + h) * f + c2_ * f * f);
}

double Ramp::duration(double slow, double fast) const {
  if (!(slow < fast)) return 0;
  if (!is_step()) return times_.acceleration > 0 ? course(fast - slow).time() : 0;
  double time = 0;
  for_each_step(slow, fast, [&](double from, double to, double a) { time += (to - from) / a; });
  return time;
}

double Ramp::way(double slow, double fast) const {
  if (!(slow < fast)) return 0;
  if (!is_step()) return times_.acceleration > 0 ? way_of(course(fast - slow), slow) : 0;
  double way = 0;
  for_each_step(slow, fast,
                [&](double from, double to, double a) { way += (to - from) * (to + from) / (2 * a); });
  return way;
}

Ramp::Reach Ramp::reach(double slow, double fast) const {
  double const change = fast - slow;
  if (!closed_ || !(change > 0) || change >= half_change_) {
    return {.way = way(slow, fast), .growth = growth(slow, fast)};
  }
  double const q = std::sqrt(change / half_change_);
  double const linear = slow * change_time_;
  double const square = cubic_ * q * q;
  return {.way = q * (linear + square), .growth = q * (linear + 3 * square) / (2 * change)};
}

double Ramp::growth(double slow, double fast) const {
  if (is_step()) {
    std::size_t i = count_ - 1;
    while (i > 0 && steps_[i].above >= fast) --i;
    return fast / steps_[i].acceleration;
  }
  double const a = times_.acceleration;
  if (!(a > 0)) return 0;
  double const both = times_.at_slow_end + times_.at_fast_end;
  double const change = fast - slow;
  if (2 * change >= a * both) {
    if (rules_.whole_change) return 2 * fast / a;
    double const held = change / a - both / 2;
    return slow / a + times_.at_slow_end / 2 + times_.at_fast_end + held;
  }
  if (rules_.constant_times) return 2 * cubic_ / (a * both);
  if (!(change > 0)) return unlimited;
  double const q = std::sqrt(2 * change / (a * both));
  return (slow * both + 3 * cubic_ * q * q) * q / (2 * change);
}

double Ramp::fastest(double slow, double length) const {
  double share = 1;
  return fastest(slow, length, share);
}

double Ramp::fastest(double slow, double length, double& share) const {
  double const linear = slow * change_time_;
  if (closed_ && length < linear + cubic_ && length > 0) {
    double above = share;
    if (linear > cubic_) {
      above = std::min(above, length / linear);
    } else if (share == 1) {
      above = std::min(1.0, std::cbrt(length / cubic_));
    }
    share = cubic_root(cubic_, linear, length, above);
    return slow + share * share * half_change_;
  }
  double const reached = fastest_continuous(slow, length);
  if (!rules_.whole_cycles) return reached;
  // Rounded up, every time is longer.
  double low = slow;
  double high = reached;
  for (int i = 0; i < halvings && low < high; ++i) {
    double const middle = (low + high) / 2;
    (way(slow, middle) <= length ? low : high) = middle;
  }
  return low;
}

double Ramp::fastest_continuous(double slow, double length) const {
  if (!(length > 0)) return slow;
  if (is_step()) {
    double v = slow;
    for (std::size_t i = 0; i < count_; ++i) {
      bool const is_last = i + 1 == count_;
      if (!is_last && steps_[i + 1].above <= v) continue;
      double const a = steps_[i].acceleration;
      double const within =
          is_last ? unlimited : (steps_[i + 1].above - v) * (steps_[i + 1].above + v) / (2 * a);
      if (within >= length) return std::sqrt(v * v + 2 * a * length);
      length -= within;
      v = steps_[i + 1].above;
    }
    return v;
  }
  double const a = times_.acceleration;
  if (!(a > 0)) return unlimited;
  double const both = times_.at_slow_end + times_.at_fast_end;
  double const linear = slow * both;
  if (length < linear + cubic_) {
    if (rules_.constant_times) {
      // The change takes its time even when it is small.
      return length <= linear ? slow : slow + (length - linear) / cubic_ * (a * both / 2);
    }
    double const above = std::min(1.0, linear > cubic_ ? length / linear : std::cbrt(length / cubic_));
    double const q = cubic_root(cubic_, linear, length, above);
    return slow + q * q * half_change_;
  }
  if (rules_.whole_change) return std::sqrt(slow * slow + a * length);
  double const b = slow + a * (times_.at_slow_end / 2 + times_.at_fast_end);
  double const rest = length - linear - cubic_;
  double const held = 2 * rest / (b + std::sqrt(b * b + 2 * a * rest));
  return slow + a * (both / 2 + held);
}

double Ramp::slowest(double slow, double fast, double length) const {
  if (way(0, fast) > length * (1 + 1e-9)) return -1;
  double low = 0;
  double high = slow;
  for (int i = 0; i < halvings && low < high; ++i) {
    double const middle = (low + high) / 2;
    (way(middle, fast) <= length ? low : high) = middle;
  }
  return low;
}

namespace {

/// A ramp of the acceleration from 0 to the peak, or back.
Phase ramp_of(double time, double velocity, double peak, bool rises, bool sine) {
  Phase phase;
  phase.duration = time;
  phase.velocity = velocity;
  if (sine) {
    phase.shape = rises ? PhaseShape::sine_rise : PhaseShape::sine_fall;
    phase.acceleration = peak;
    phase.sine_time = time;
  } else {
    phase.acceleration = rises ? 0 : peak;
    phase.jerk = (rises ? peak : -peak) / time;
  }
  return phase;
}

void append(Phase phase, std::vector<Phase>& phases) {
  if (!(phase.duration > 0)) return;
  phase.length = std::numeric_limits<double>::infinity();
  phase.length = phase.way_at(phase.duration);
  phases.push_back(phase);
}

}  // namespace

void Ramp::append_up(double from, double to, std::vector<Phase>& phases) const {
  if (!(from < to)) return;
  if (is_step()) {
    for_each_step(from, to, [&](double slow, double fast, double a) {
      append({.duration = (fast - slow) / a, .velocity = slow, .acceleration = a}, phases);
    });
    return;
  }
  if (!(times_.acceleration > 0)) return;
  auto const [peak, slow_end, held, fast_end] = course(to - from);
  append(ramp_of(slow_end, from, peak, true, rules_.sine), phases);
  append({.duration = held, .velocity = from + peak * slow_end / 2, .acceleration = peak}, phases);
  append(ramp_of(fast_end, to - peak * fast_end / 2, peak, false, rules_.sine), phases);
}

void Ramp::append_down(double from, double to, std::vector<Phase>& phases) const {
  if (!(to < from)) return;
  if (is_step()) {
    auto const first = static_cast<std::ptrdiff_t>(phases.size());
    for_each_step(to, from, [&](double slow, double fast, double a) {
      append({.duration = (fast - slow) / a, .velocity = fast, .acceleration = -a}, phases);
    });
    std::reverse(phases.begin() + first, phases.end());
    return;
  }
  if (!(times_.acceleration > 0)) return;
  auto const [peak, slow_end, held, fast_end] = course(from - to);
  append(ramp_of(fast_end, from, -peak, true, rules_.sine), phases);
  append({.duration = held, .velocity = from - peak * fast_end / 2, .acceleration = -peak}, phases);
  append(ramp_of(slow_end, to + peak * slow_end / 2, -peak, false, rules_.sine), phases);
}

}  // namespace axisc::motion
