#include "analysis/motion/planning/phase_cutter.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

constexpr int most_time_steps = 100;
constexpr double same_share = 2e-16;

}  // namespace

Phase part_of(Phase const& phase, double from, double to) {
  Phase part = phase;
  part.duration = to - from;
  part.velocity = phase.velocity_at(from);
  if (phase.shape == PhaseShape::constant_jerk) {
    part.acceleration = phase.acceleration_at(from);
  } else {
    part.sine_begun = phase.sine_begun + from;
  }
  part.length = phase.way_at(to) - phase.way_at(from);
  return part;
}

double time_at(Phase const& phase, double way, double near) {
  double low = 0;
  double high = phase.duration;
  double time = std::clamp(near, low, high);
  for (int i = 0; i < most_time_steps; ++i) {
    double const over = phase.way_at(time) - way;
    (over <= 0 ? low : high) = time;
    double const velocity = phase.velocity_at(time);
    double next = velocity > 0 ? time - over / velocity : low;
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    bool const is_close = std::abs(next - time) <= same_share * phase.duration;
    time = next;
    if (is_close) break;
  }
  return time;
}

void PhaseCutter::advance(double length, std::vector<Phase>* parts) {
  highest_ = velocity();
  while (at_ < phases_.size()) {
    auto const& phase = phases_[at_];
    double const rest = phase.length - way_;
    bool const is_whole = length >= rest;
    double until = phase.duration;
    if (!is_whole) {
      double const velocity = phase.velocity_at(time_);
      double const near = velocity > 0 ? time_ + length / velocity : phase.duration / 2;
      until = time_at(phase, way_ + length, near);
    }
    if (parts != nullptr && until > time_) {
      parts->push_back(part_of(phase, time_, until));
      parts->back().length = is_whole ? rest : length;
    }
    if (!is_whole) {
      time_ = until;
      way_ += length;
      break;
    }
    length -= rest;
    ++at_;
    time_ = way_ = 0;
    highest_ = std::max(highest_, velocity());
    if (!(length > 0)) break;
  }
  highest_ = std::max(highest_, velocity());
}

double PhaseCutter::velocity() const {
  if (at_ < phases_.size()) return time_ > 0 ? phases_[at_].velocity_at(time_) : phases_[at_].velocity;
  return phases_.empty() ? 0 : phases_.back().velocity_out();
}

}  // namespace axisc::motion
