#include "runtime/bounds/bound_record.hpp"
#include "runtime/verification/verify_checks.hpp"

namespace axisc::runtime {
namespace {

template <class... Numbers>
bool are_not_negative(Numbers... numbers) {
  return ((numbers >= 0) && ...);
}

/// Checks everything that can be judged without computing it again.
axisrt_status check_claims(bounds::BoundRecord const& record, double gain_at_zero) {
  axisrt_status const status =
      check_finite(record.gain_low, record.gain_high, record.overshoot_high, record.distance_high,
                   record.radius_high, record.rounding_increment, record.rounding_position,
                   record.state_increment, record.state_position, record.limit_error);
  if (status != AXISRT_OK) return status;
  return check_bounds(record.flags <= axim_bound_majorant, record.gain_low >= 0,
                      record.gain_low <= record.gain_high, record.gain_high >= gain_at_zero,
                      record.radius_high >= 0, record.radius_high <= 1,
                      are_not_negative(record.overshoot_high, record.distance_high, record.rounding_increment,
                                       record.rounding_position, record.state_increment,
                                       record.state_position, record.limit_error));
}

double gain_at_zero(ImageView const& view, bounds::FilterRange filters) {
  double gain = 1;
  for (uint32_t i = 0; i < filters.count; ++i)
    gain *= view.filters[filters.first + i][field::filter::dc_gain];
  return gain;
}

}  // namespace

axisrt_status check_bound_records(ImageView const& view) {
  if (view.bounds.first == nullptr) return AXISRT_OK;
  bounds::BoundKeys keys(view);
  bounds::BoundKey key{};
  uint32_t i = 0;
  for (; keys.next(key); ++i) {
    if (i == view.bounds.count) return AXISRT_OUT_OF_BOUNDS;
    bounds::BoundRecord const record = bounds::stored_record(view.bounds[i]);
    axisrt_status const status = first_failure(
        [&] {
          return check_bounds(record.axis == key.axis, record.port == key.port, record.kernel == key.kernel,
                              record.stage == key.stage);
        },
        [&] { return check_claims(record, gain_at_zero(view, bounds::filters_of(view, key))); });
    if (status != AXISRT_OK) return status;
  }
  return check_bounds(i == view.bounds.count);
}

}  // namespace axisc::runtime
