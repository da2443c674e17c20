#include "runtime/limits.hpp"
#include "runtime/verification/verify_checks.hpp"

namespace axisc::runtime {
namespace {

axisrt_status check_stage(ImageView const& view, uint32_t axis, Record<record::stage> stage,
                          uint32_t& next_filter) {
  uint32_t const mode = stage[field::stage::mode];
  if (mode < 1 || mode > 3) return AXISRT_UNKNOWN_KIND;
  double const weight = stage[field::stage::weight];
  return first_failure(
      [&] {
        return check_finite(weight, stage[field::stage::weight_numerator],
                            stage[field::stage::weight_denominator]);
      },
      [&] {
        return check_bounds(weight >= 0 && weight <= largest_weight,
                            stage[field::stage::index] < axim_most_stages,
                            stage[field::stage::filter_count] >= 1);
      },
      [&] {
        return check_chain(view, axis, axim_port_velocity, stage[field::stage::first_filter],
                           stage[field::stage::filter_count], axim_most_stage_filters, next_filter);
      });
}

axisrt_status check_numbers(Record<record::control> control) {
  double const limit = control[field::control::limit];
  double const scale = control[field::control::scale];
  axisrt_status const status =
      check_finite(limit, scale, control[field::control::limit_factor], control[field::control::v_reso_num],
                   control[field::control::v_reso_denom], control[field::control::multi_gain_z],
                   control[field::control::multi_gain_n]);
  if (status != AXISRT_OK) return status;
  return check_bounds(limit >= 0 && limit <= largest_scale, is_within(scale, largest_scale));
}

/// The source is the axis itself, or a master with stages of its own.
axisrt_status check_source(ImageView const& view, Record<record::control> control) {
  uint32_t const source = control[field::control::source];
  uint32_t const stages = control[field::control::stage_count];
  if (source == control[field::control::axis]) return check_bounds(stages >= 1, stages <= axim_most_stages);
  uint32_t const master = find_axis(view.controls, field::control::axis, source);
  return check_bounds(
      stages == 0, master < view.controls.count && view.controls[master][field::control::source] == source);
}

axisrt_status check_control(ImageView const& view, uint32_t index, uint32_t& next_stage,
                            uint32_t& next_filter) {
  Record<record::control> const control = view.controls[index];
  if (control[field::control::controller] > 2) return AXISRT_UNKNOWN_KIND;
  uint32_t const axis = control[field::control::axis];
  uint32_t const stages = control[field::control::stage_count];
  bool const ascends = index == 0 || axis > view.controls[index - 1][field::control::axis];
  axisrt_status status = first_failure(
      [&] { return check_numbers(control); },
      [&] {
        return check_bounds(axis < view.axes.count, ascends, control[field::control::time_base] <= 2,
                            control[field::control::source] < view.axes.count,
                            view.stages.holds(next_stage, stages),
                            stages == 0 || control[field::control::first_stage] == next_stage);
      },
      [&] { return check_source(view, control); });
  for (uint32_t i = 0; i < stages && status == AXISRT_OK; ++i) {
    status = check_stage(view, axis, view.stages[next_stage + i], next_filter);
  }
  next_stage += stages;
  return status;
}

}  // namespace

axisrt_status check_controls(ImageView const& view, uint32_t& next_filter) {
  uint32_t next_stage = 0;
  for (uint32_t i = 0; i < view.controls.count; ++i) {
    axisrt_status const status = check_control(view, i, next_stage, next_filter);
    if (status != AXISRT_OK) return status;
  }
  return check_bounds(next_stage == view.stages.count);
}

}  // namespace axisc::runtime
