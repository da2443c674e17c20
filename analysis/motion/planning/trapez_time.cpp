#include "analysis/motion/planning/trapez_time.hpp"

namespace axisc::motion {
namespace {

PathLimits as_trapez(PathLimits const& limits) {
  auto dynamics = limits.dynamics();
  dynamics.readings.hsc = machine::HscReading::trapez;
  return PathLimits(std::move(dynamics));
}

}  // namespace

TrapezTime::TrapezTime(PathLimits const& limits) : planner_(as_trapez(limits), false, *this) {}

void TrapezTime::begin(Point const& position, double acceleration_factor) {
  planner_.begin(position, {}, acceleration_factor);
  cycles_ = 0;
  has_hsc_ = false;
}

void TrapezTime::add(ProgrammedBlock const& block) {
  planner_.add(block);
}

std::optional<double> TrapezTime::cycles() const {
  return has_hsc_ ? std::optional(cycles_) : std::nullopt;
}

void TrapezTime::piece(PathBlock const& block, Phase const& phase) {
  has_hsc_ = has_hsc_ || block.mode->slope == machine::Slope::hsc;
  cycles_ += phase.duration;
}

}  // namespace axisc::motion
