// The task of a filter for an axis: which resonances it must not excite, and how far the contour may deviate.
#pragma once

#include "analysis/motion/planning/axis_mode.hpp"
#include "configuration/machine/machine.hpp"
#include "design/filter_specification.hpp"
#include "design/kernels/kernel_design.hpp"
#include "design/units.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace axisc::tuning {

struct Resonance {
  double frequency = 0;             ///< Hz
  std::optional<double> damping{};  ///< ratio, where known
  double uncertainty = 0;           ///< of the frequency, Hz
};

/// The goal: surface asks for little vibration, accuracy for little deviation, speed for a short delay.
enum class Goal : std::uint8_t { surface, accuracy, speed };

/// Whether lists of the machine may have a kernel of some families.
enum class Standing : std::uint8_t {
  allowed,
  excluded,  ///< by a command in a program of the channel: lists with it would have findings
  unknown,   ///< to the build of the control
};

/// Lengths are position units, velocities units per cycle.
struct Task {
  design::CycleTime cycle_time;
  std::vector<Resonance> resonances;
  double velocity = 0;
  motion::PathDynamics dynamics = {};  ///< of the axis alone, with the slope of its channel
  double tolerance = 0;                ///< of the axis error
  double radius = 0;                   ///< of a circle on which the velocity keeps the tolerance
  std::optional<Goal> goal = std::nullopt;
  /// HSC: the control's build does not have FIR filters.
  machine::KernelFamily family = machine::KernelFamily::fir;
  Standing kernels = Standing::allowed;  ///< of that family; #VIB GUARD excludes them
  Standing guards = Standing::allowed;   ///< Vibration Guard; #FILTER excludes it
  design::Readings readings{};           ///< how the control computes its filters
};

/// A setpoint chain: standard filters one after the other, then a kernel, which may be a Vibration Guard.
struct Chain {
  std::vector<design::FilterSpecification> filters = {};
  std::optional<design::KernelSpecification> kernel = std::nullopt;

  friend bool operator==(Chain const&, Chain const&) = default;
};

[[nodiscard]] inline bool has_guard(Chain const& chain) {
  return chain.kernel && chain.kernel->type == design::KernelType::vibration_guard;
}

/// Of the chain's kernel, on a control whose linear-phase kernels are of `linear_phase`.
[[nodiscard]] inline machine::KernelFamily family_of(Chain const& chain, machine::KernelFamily linear_phase) {
  return has_guard(chain) ? machine::KernelFamily::guard : linear_phase;
}

}  // namespace axisc::tuning
