#include "runtime/bounds/bound_record.hpp"
#include "runtime/verification/verify_checks.hpp"

namespace axisc::runtime::bounds {

bool BoundKeys::next(BoundKey& key) {
  while (axis_ < view_.axes.count) {
    if (next_of_axis(key)) return true;
    axis_ += 1;
    phase_ = 0;
  }
  if (stage_ >= view_.stages.count) return false;
  uint32_t const filter = view_.stages[stage_][field::stage::first_filter];
  key = {.axis = view_.filters[filter][field::filter::axis],
         .port = axim_port_velocity,
         .kernel = AXIM_NONE,
         .stage = stage_++};
  return true;
}

bool BoundKeys::next_of_axis(BoundKey& key) {
  Record<record::axis> const axis = view_.axes[axis_];
  uint32_t const slot = find_axis(view_.slots, field::slot::axis, axis_);
  bool const has_slot = slot < view_.slots.count;
  key = {.axis = axis_, .port = axim_port_setpoint, .kernel = AXIM_NONE, .stage = 0};
  if (phase_ == 0) {
    phase_ = 1;
    kernel_ = AXIM_NONE;
    if (axis[field::axis::filter_count] > 0 || has_slot) return true;
  }
  if (phase_ == 1) {
    kernel_ = has_slot ? next_kernel(slot, kernel_) : AXIM_NONE;
    key.kernel = kernel_;
    if (kernel_ != AXIM_NONE) return true;
    phase_ = 2;
    key.port = axim_port_interface;
    return axis[field::axis::interface_filter_count] > 0;
  }
  return false;
}

/// Of the lists' kernel and those of the banks of its channel, the next one after `after`.
uint32_t BoundKeys::next_kernel(uint32_t slot, uint32_t after) const {
  Record<record::slot> const record = view_.slots[slot];
  uint32_t next = AXIM_NONE;
  auto const consider = [&](uint32_t kernel) {
    bool const is_later = after == AXIM_NONE || kernel > after;
    if (kernel != AXIM_NONE && is_later && kernel < next) next = kernel;
  };
  consider(record[field::slot::kernel]);
  uint32_t const number = record[field::slot::group];
  if (number == AXIM_NONE) return next;
  Record<record::group> const group = view_.groups[number];
  uint32_t const place = record[field::slot::member] - group[field::group::first_member];
  for (uint32_t i = 0; i < group[field::group::bank_count]; ++i) {
    uint32_t const choice =
        view_.banks[group[field::group::first_bank] + i][field::bank::first_choice] + place;
    consider(view_.choices[choice][field::choice::kernel]);
  }
  return next;
}

FilterRange filters_of(ImageView const& view, BoundKey const& key) {
  if (key.port == axim_port_velocity) {
    Record<record::stage> const stage = view.stages[key.stage];
    return {stage[field::stage::first_filter], stage[field::stage::filter_count]};
  }
  Record<record::axis> const axis = view.axes[key.axis];
  if (key.port == axim_port_interface) {
    return {axis[field::axis::first_interface_filter], axis[field::axis::interface_filter_count]};
  }
  return {axis[field::axis::first_filter], axis[field::axis::filter_count]};
}

bool has_kernel_before(ImageView const& view, uint32_t axis) {
  uint32_t const slot = find_axis(view.slots, field::slot::axis, axis);
  return slot < view.slots.count && view.slots[slot][field::slot::family] == axim_family_hsc;
}

BoundRecord stored_record(Record<record::bound> record) {
  namespace bound = field::bound;
  return {.axis = record[bound::axis],
          .port = record[bound::port],
          .kernel = record[bound::kernel],
          .flags = record[bound::flags],
          .cycles = record[bound::cycles],
          .stage = record[bound::stage],
          .gain_low = record[bound::gain_low],
          .gain_high = record[bound::gain_high],
          .overshoot_high = record[bound::overshoot_high],
          .distance_high = record[bound::distance_high],
          .radius_high = record[bound::radius_high],
          .rounding_increment = record[bound::rounding_increment],
          .rounding_position = record[bound::rounding_position],
          .state_increment = record[bound::state_increment],
          .state_position = record[bound::state_position],
          .rest_cycles = record[bound::rest_cycles],
          .limit_error = record[bound::limit_error]};
}

}  // namespace axisc::runtime::bounds
