#include "axisc/answers/dynamics/driven_axis.hpp"

#include "analysis/motion/contour/corner_passage.hpp"
#include "axisc/answers/execution/group_chains.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace axisc {

DrivenAxis::DrivenAxis(machine::Machine const& machine, std::size_t axis,
                       machine::MachineGroup const& channel)
    : path_{.axes = {machine.axes[axis].dynamics},
            .channel = channel.dynamics,
            .readings = machine.motion,
            .cycle_time = machine.cycle_time} {
  for (auto const* const parameters : {&channel.uncomputed, &machine.axes[axis].uncomputed}) {
    for (auto const& parameter : *parameters) uncomputed_.push_back(parameter.number);
  }
}

PlannedMove DrivenAxis::feed(WantedMove const& move) const {
  return planned({.length = move.distance_mm * motion::units_per_mm,
                  .feed = path_velocity(move.feed_mm_per_min, path_.cycle_time),
                  .rapid = false});
}

PlannedMove DrivenAxis::rapid(double distance_mm) const {
  return planned({.length = distance_mm * motion::units_per_mm, .feed = 0, .rapid = true});
}

PlannedMove DrivenAxis::planned(motion::SingleMove const& move) const {
  PlannedMove planned{.phases = motion::phases_of(path_, move)};
  double cycles = 0;
  double highest = 0;
  for (auto const& phase : planned.phases) {
    cycles += phase.duration;
    // From rest to rest the velocity has one hump, whose top is where a phase begins.
    highest = std::max(highest, phase.velocity);
  }
  planned.seconds = seconds(cycles);
  planned.velocity = velocity(highest);
  return planned;
}

double DrivenAxis::corner_velocity() const {
  motion::CornerTask const right_angle{.turn = std::numbers::pi / 2,
                                       .feed = std::numeric_limits<double>::infinity()};
  return velocity(motion::pass_corner(path_, right_angle).front().velocity);
}

motion::AxisMode DrivenAxis::mode(bool rapid) const {
  return motion::block_mode(path_, nullptr, rapid, 1).axes.front();
}

double DrivenAxis::velocity(double value) const {
  return value / motion::units_per_mm / path_.cycle_time.seconds();
}

double DrivenAxis::acceleration(double value) const {
  return velocity(value) / path_.cycle_time.seconds();
}

double DrivenAxis::jerk(double value) const {
  constexpr double mm_per_m = 1000;
  return acceleration(value) / path_.cycle_time.seconds() / mm_per_m;
}

std::optional<DrivenAxis> driven_axis(machine::Machine const& machine, std::size_t axis) {
  auto const channel = channel_of_axis(machine, axis);
  if (!channel) return std::nullopt;
  return DrivenAxis(machine, machine.axes[axis].gantry_master.value_or(axis), machine.groups[*channel]);
}

}  // namespace axisc
