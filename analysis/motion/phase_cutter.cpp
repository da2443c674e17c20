#include "analysis/motion/phase_cutter.hpp"

#include <algorithm>

namespace axisc::motion {
namespace {

constexpr int most_steps = 100;
constexpr double same_share = 1e-16;

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

double time_at(Phase const& phase, double way) {
  double low = 0;
  double high = phase.duration;
  double time = std::clamp(phase.length > 0 ? high * way / phase.length : 0, low, high);
  for (int i = 0; i < most_steps && high - low > same_share * phase.duration; ++i) {
    double const over = phase.way_at(time) - way;
    (over <= 0 ? low : high) = time;
    double const velocity = phase.velocity_at(time);
    double next = velocity > 0 ? time - over / velocity : low;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (next == time) break;
    time = next;
  }
  return time;
}

void PhaseCutter::cut(double length, std::vector<Phase>& parts) {
  while (at_ < phases_.size()) {
    auto const& phase = phases_[at_];
    double const rest = phase.length - way_;
    bool const is_whole = length >= rest;
    double const until = is_whole ? phase.duration : time_at(phase, way_ + length);
    auto part = part_of(phase, time_, until);
    part.length = is_whole ? rest : length;
    if (part.duration > 0) parts.push_back(part);
    if (!is_whole) {
      time_ = until;
      way_ += length;
      return;
    }
    length -= rest;
    ++at_;
    time_ = way_ = 0;
    if (!(length > 0)) return;
  }
}

double PhaseCutter::velocity() const {
  if (at_ < phases_.size()) return phases_[at_].velocity_at(time_);
  return phases_.empty() ? 0 : phases_.back().velocity_out();
}

}  // namespace axisc::motion
