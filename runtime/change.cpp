#include "runtime/change.hpp"

#include "axisrt.h"
#include "runtime/comparison.hpp"
#include "runtime/configuration.hpp"
#include "runtime/control_word.hpp"
#include "runtime/lane.hpp"
#include "runtime/limits.hpp"
#include "runtime/recorder.hpp"
#include "runtime/step_distance.hpp"

namespace axisc::runtime {
namespace {

constexpr uint32_t longest_fade = 4096;
/// Cycles in which both runtimes must have had equal outputs, with constant setpoints.
constexpr uint32_t standstill_cycles = 64;

Block memory_of_recorder(axisrt const& runtime) {
  axisrt_recorder const* const recorder = runtime.recorder;
  return {.first = recorder, .size = recorder != nullptr ? recorder->memory_size : 0};
}

double smaller(double a, double b) {
  return a < b ? a : b;
}

/// The fewest cycles F with  15/(8 F) L v <= v/4  and  10/(sqrt(3) F^2) L v + 15/(4 F) L a <= a/4 ; 0 if
/// there are none up to longest_fade. L v is the largest distance of the two outputs, L a its largest change
/// in a cycle.
uint32_t fade_cycles(double distance, double velocity, double acceleration) {
  if (!(velocity > 0) || !(acceleration > 0)) return 0;
  constexpr double factor = 23.094010767585031;  // 40 / sqrt(3)
  double const constant = factor * distance * (velocity / acceleration);
  for (uint32_t f = 1; f <= longest_fade; ++f) {
    if (static_cast<double>(f) * (f - 15 * distance) >= constant) return f;
  }
  return 0;
}

/// What an image proves for kernel and filters together is sharper than the computed sum of both.
double distance_of(Axis const& axis, StepDistance const& computed) {
  return axis.distance >= 0 ? axis.distance : computed.sum;
}

/// How long the change must take, and how long the new runtime must have run along with the old one before.
void plan(axisrt const& active, axisrt const& prepared, Change& change) {
  change.length = 1;
  change.warm_up = 0;
  for (uint32_t i = 0; i < prepared.axis_count && change.length > 0; ++i) {
    StepDistance const a = step_distance(active, active.setpoint, i);
    StepDistance const b = step_distance(prepared, prepared.setpoint, i);
    double const velocity = smaller(active.axes[i].velocity_limit, prepared.axes[i].velocity_limit);
    double const acceleration =
        smaller(active.axes[i].acceleration_limit, prepared.axes[i].acceleration_limit);
    double const distance = distance_of(active.axes[i], a) + distance_of(prepared.axes[i], b);
    uint32_t const cycles = a.is_bounded && b.is_bounded ? fade_cycles(distance, velocity, acceleration) : 0;
    if (cycles == 0 || cycles > change.length) change.length = cycles;
    if (b.settling > change.warm_up) change.warm_up = b.settling;
  }
  change.same_controls = same_controls(active, prepared) ? 1 : 0;
  if (change.same_controls == 0) change.length = 0;
}

bool was_reset(LinePort const& port, uint32_t line) {
  return Lane(port, port.lines[line]).reset_done();
}

double input_of(LinePort const& port, uint32_t line) {
  return Lane(port, port.lines[line]).part(GroupParts::input);
}

double output_of(LinePort const& port, uint32_t line) {
  return Lane(port, port.lines[line]).part(GroupParts::output);
}

/// The steady state for the latest inputs of the active runtime.
void take_over(axisrt const& active, axisrt& prepared) {
  for (uint32_t i = 0; i < prepared.axis_count; ++i) {
    if (was_reset(active.setpoint, i)) axisrt_reset(&prepared, i, input_of(active.setpoint, i));
    if (was_reset(active.additional_interface, i)) {
      axisrt_reset_interface(&prepared, i, input_of(active.additional_interface, i));
    }
  }
  if (prepared.change->same_controls == 0) return;
  for (uint32_t i = 0; i < prepared.stage_count; ++i) {
    if (!was_reset(active.velocity, i)) continue;
    reset_line(prepared, prepared.velocity, i, input_of(active.velocity, i));
  }
}

bool any_fades(axisrt const& runtime) {
  for (uint32_t i = 0; i < runtime.slot_count; ++i) {
    if (is_fading(runtime.slots[i])) return true;
  }
  return false;
}

/// Counts cycles in which nothing moves and both runtimes have the same outputs.
void watch_standstill(axisrt const& active, axisrt const& prepared, double const* inputs_before,
                      Change& change) {
  bool stands = true;
  for (uint32_t i = 0; i < prepared.axis_count; ++i) {
    double const moved = input_of(active.setpoint, i) - inputs_before[i];
    double const apart = output_of(active.setpoint, i) - output_of(prepared.setpoint, i);
    stands =
        stands && is_within(moved, largest_increment_at_rest) && is_within(apart, largest_increment_at_rest);
  }
  change.standstill = stands ? change.standstill + 1 : 0;
}

/// One cycle of a port with the latest inputs of the active runtime's port.
void shadow_port(axisrt const& prepared, LinePort const& from, LinePort const& to, double* inputs) {
  for (uint32_t i = 0; i < to.port.line_count; ++i) inputs[i] = input_of(from, i);
  prepared.instructions->step(to.port, inputs, inputs, nullptr);
}

void shadow(axisrt& prepared) {
  axisrt const& active = *prepared.change->predecessor;
  Change& change = *prepared.change;
  for (uint32_t i = 0; i < prepared.axis_count; ++i) {
    change.outputs[i] = input_of(prepared.setpoint, i);
    // An axis that was reset since: its chains remember another position.
    if (was_reset(active.setpoint, i) && !was_reset(prepared.setpoint, i)) {
      axisrt_reset(&prepared, i, input_of(active.setpoint, i));
    }
  }
  shadow_port(prepared, active.setpoint, prepared.setpoint, change.shadow);
  watch_standstill(active, prepared, change.outputs, change);
  shadow_port(prepared, active.additional_interface, prepared.additional_interface, change.shadow);
  if (change.same_controls != 0) shadow_port(prepared, active.velocity, prepared.velocity, change.shadow);
  change.cycles += 1;
}

}  // namespace

void advance(Change& change) {
  change.position += 1;
  if (change.position >= change.length) change.predecessor = nullptr;
}

}  // namespace axisc::runtime

axisrt_status axisrt_prepare(axisrt* active, axisrt_config const* config, uint32_t options,
                             axisrt** prepared) {
  using namespace axisc::runtime;
  if (prepared == nullptr) return AXISRT_BAD_ARGUMENT;
  *prepared = nullptr;
  if (active == nullptr || !is_known(config)) return AXISRT_BAD_ARGUMENT;
  if (active->change->predecessor != nullptr) return AXISRT_BUSY;
  axisrt* made = nullptr;
  axisrt_status const status = create_beside(*config, {.first = active, .size = active->memory_size},
                                             memory_of_recorder(*active), made);
  if (status != AXISRT_OK) return status;
  if (!same_axes(*active, *made)) return AXISRT_OTHER_AXES;
  bool const older = made->image_version < active->image_version;
  if (older && (options & AXISRT_ALLOW_OLDER) == 0) return AXISRT_OLDER_IMAGE;
  made->change->predecessor = active;
  in_plain_arithmetic([&] {
    plan(*active, *made, *made->change);
    take_over(*active, *made);
  });
  *prepared = made;
  return AXISRT_OK;
}

axisrt_status axisrt_shadow_step(axisrt* prepared) {
  using namespace axisc::runtime;
  if (prepared == nullptr || prepared->change->predecessor == nullptr || prepared->change->begun != 0) {
    return AXISRT_BAD_ARGUMENT;
  }
  in_cycle_arithmetic([&] { shadow(*prepared); });
  return AXISRT_OK;
}

axisrt_status axisrt_swap(axisrt* prepared) {
  using namespace axisc::runtime;
  if (prepared == nullptr || prepared->change->predecessor == nullptr || prepared->change->begun != 0) {
    return AXISRT_BAD_ARGUMENT;
  }
  Change& change = *prepared->change;
  axisrt& active = *change.predecessor;
  if (any_fades(active) || any_fades(*prepared)) return AXISRT_BUSY;
  bool const stands = change.standstill >= standstill_cycles;
  if (!stands && change.length == 0) return AXISRT_NEEDS_STANDSTILL;
  if (!stands && change.cycles < change.warm_up) return AXISRT_NOT_WARM;
  axisrt_recorder_stop(active.recorder);
  if (change.length == 0) change.predecessor = nullptr;
  change.begun = 1;
  change.position = 0;
  return AXISRT_OK;
}

int axisrt_swap_done(axisrt const* runtime) {
  return runtime != nullptr && runtime->change->begun != 0 && runtime->change->predecessor == nullptr ? 1 : 0;
}
