#include "axisrt.h"
#include "runtime/control_word.hpp"
#include "runtime/limits.hpp"
#include "runtime/verification/verify_checks.hpp"

namespace axisc::runtime {
namespace {

constexpr uint32_t longest_cycle_ns = 1'000'000'000;
constexpr double half_ulp_of_one = 0x1p-53;

axisrt_status check_section(Record<record::coefficients> section) {
  double const p = section[field::coefficients::p];
  double const q = section[field::coefficients::q];
  double const k = section[field::coefficients::k];
  double const b = section[field::coefficients::b];
  axisrt_status const status = check_finite(p, q, k, b);
  if (status != AXISRT_OK) return status;
  // Poles inside the unit circle: A(1) = k > 0, |a2| = |1 - b| < 1, A(-1) = 4 - k - 2b > 0.
  bool const is_stable = k > 0 && b > 0 && b < 2 && 4 - k - 2 * b > 0;
  bool const is_moderate = is_within(p, largest_numerator) && is_within(q, largest_numerator);
  return is_stable && is_moderate ? AXISRT_OK : AXISRT_UNSTABLE;
}

bool is_known_axis_type(uint32_t type) {
  return type == 1 || type == 2 || type == 4;
}

/// 0 is the oscillator, which is only in stages.
bool is_known_filter_type(uint32_t type, uint32_t port) {
  if (type == 0) return port == axim_port_velocity;
  constexpr uint32_t known =
      1U << 1U | 1U << 2U | 1U << 3U | 1U << 4U | 1U << 5U | 1U << 6U | 1U << 10U | 1U << 11U;
  return type < 32 && ((known >> type) & 1U) != 0;
}

axisrt_status check_kinds(Record<record::filter> filter) {
  uint32_t const prototype = filter[field::filter::prototype];
  uint32_t const port = filter[field::filter::port];
  bool const known = port <= axim_port_velocity && filter[field::filter::realisation] <= 2 &&
                     filter[field::filter::activation] == 0 &&
                     is_known_filter_type(filter[field::filter::type], port) && prototype >= 1 &&
                     prototype <= 3;
  return known ? AXISRT_OK : AXISRT_UNKNOWN_KIND;
}

axisrt_status check_share(Record<record::filter> filter) {
  double const share = filter[field::filter::share];
  double const direct = filter[field::filter::direct];
  double const direct_low = filter[field::filter::direct_low];
  axisrt_status const status = check_finite(share, direct, direct_low);
  if (status != AXISRT_OK) return status;
  return check_bounds(share >= 0 && share <= 1, direct >= 0 && direct <= 1,
                      is_within(direct_low, half_ulp_of_one),
                      is_within(share + direct - 1, 2 * half_ulp_of_one));
}

axisrt_status check_realisation(ImageView const& view, Record<record::filter> filter) {
  uint32_t const sections = filter[field::filter::section_count];
  uint32_t const blocks_constant = filter[field::filter::blocks_constant];
  if (filter[field::filter::delay_cycles] > axim_most_delay) return AXISRT_KERNEL_TOO_LONG;
  bool const has_sections = filter[field::filter::realisation] == axim_realisation_sections;
  if (!has_sections) return check_bounds(sections == 0, blocks_constant == 0);
  return check_bounds(sections >= 1, sections <= axim_most_sections, blocks_constant <= 1,
                      view.coefficients.holds(filter[field::filter::first_section], sections));
}

/// Checks everything in the proof that can be judged without computing it again.
axisrt_status check_proof(Record<record::filter> filter) {
  double const radius = filter[field::filter::pole_radius];
  double const gain_at_zero = filter[field::filter::dc_gain];
  double const peak_gain = filter[field::filter::peak_gain];
  double const overshoot = filter[field::filter::overshoot];
  axisrt_status const status = check_finite(radius, gain_at_zero, filter[field::filter::group_delay],
                                            filter[field::filter::kernel_sum], peak_gain, overshoot);
  if (status != AXISRT_OK) return status;
  bool const blocks = filter[field::filter::blocks_constant] != 0;
  return check_bounds(
      radius >= 0 && radius <= 1, gain_at_zero == (blocks ? filter[field::filter::direct] : 1),
      filter[field::filter::kernel_sum] == 1, is_possible_gain(peak_gain, gain_at_zero), overshoot >= 0);
}

axisrt_status check_filter(ImageView const& view, Record<record::filter> filter) {
  return first_failure(
      [&] { return check_kinds(filter); }, [&] { return check_share(filter); },
      [&] { return check_realisation(view, filter); },
      [&] {
        return check_samples(view, filter[field::filter::first_sample], filter[field::filter::sample_count]);
      },
      [&] {
        return check_finite(filter[field::filter::frequency], filter[field::filter::quality],
                            filter[field::filter::time_constant], filter[field::filter::share_percent]);
      },
      [&] { return check_proof(filter); });
}

/// `first`: of the axis' setpoint filters, all of which have been checked.
axisrt_status check_axis_gain(ImageView const& view, Record<record::axis> axis, uint32_t first) {
  double gain_at_zero = 1;
  for (uint32_t i = 0; i < axis[field::axis::filter_count]; ++i) {
    gain_at_zero *= view.filters[first + i][field::filter::dc_gain];
  }
  return check_bounds(is_possible_gain(axis[field::axis::peak_gain], gain_at_zero));
}

axisrt_status check_axis(ImageView const& view, uint32_t index, uint32_t& next_filter) {
  Record<record::axis> const axis = view.axes[index];
  uint32_t const first_filter = next_filter;
  return first_failure(
      [&] {
        bool const known =
            is_known_axis_type(axis[field::axis::type]) && axis[field::axis::position_unit] <= 1;
        return known ? AXISRT_OK : AXISRT_UNKNOWN_KIND;
      },
      [&] {
        return check_finite(axis[field::axis::position_window], axis[field::axis::velocity_limit],
                            axis[field::axis::acceleration_limit], axis[field::axis::peak_gain],
                            axis[field::axis::delay_cycles]);
      },
      [&] {
        return check_bounds(view.names.holds(axis[field::axis::name_offset], axis[field::axis::name_size]));
      },
      [&] {
        return check_chain(view, index, axim_port_setpoint, axis[field::axis::first_filter],
                           axis[field::axis::filter_count], axim_most_filters, next_filter);
      },
      [&] { return check_axis_gain(view, axis, first_filter); },
      [&] {
        return check_chain(view, index, axim_port_interface, axis[field::axis::first_interface_filter],
                           axis[field::axis::interface_filter_count], axim_most_interface_filters,
                           next_filter);
      });
}

axisrt_status check_axes_and_chains(ImageView const& view) {
  if (view.axes.count != view.header()[field::header::axis_count]) return AXISRT_OUT_OF_BOUNDS;
  uint32_t next_filter = 0;
  for (uint32_t i = 0; i < view.axes.count; ++i) {
    axisrt_status const status = check_axis(view, i, next_filter);
    if (status != AXISRT_OK) return status;
  }
  axisrt_status const status = check_controls(view, next_filter);
  return status == AXISRT_OK ? check_bounds(next_filter == view.filters.count) : status;
}

axisrt_status check_sample(Record<record::sample> sample) {
  double const input = sample[field::sample::input];
  axisrt_status const status = check_finite(input, sample[field::sample::output]);
  if (status != AXISRT_OK) return status;
  return check_bounds(is_within(input, largest_position));
}

axisrt_status check_list(ImageView const& view, Record<record::list> list) {
  if (list[field::list::role] > 2) return AXISRT_UNKNOWN_KIND;
  return check_bounds(view.names.holds(list[field::list::name_offset], list[field::list::name_size]));
}

axisrt_status check_value(ImageView const& view, Record<record::value> value) {
  return check_bounds(value[field::value::axis] < view.axes.count,
                      value[field::value::list] < view.lists.count, value[field::value::line] >= 1,
                      view.names.holds(value[field::value::name_offset], value[field::value::name_size]),
                      view.names.holds(value[field::value::text_offset], value[field::value::text_size]));
}

axisrt_status check_cycle_time(Record<record::header> header) {
  uint32_t const cycle_time_ns = header[field::header::cycle_time_ns];
  return cycle_time_ns >= 1 && cycle_time_ns <= longest_cycle_ns ? AXISRT_OK : AXISRT_INCONSISTENT_CYCLE;
}

}  // namespace

/// Filters are in the order of their chains, so that each belongs to exactly one: `next` is the first one
/// that no chain has claimed yet.
axisrt_status check_chain(ImageView const& view, uint32_t axis, uint32_t port, uint32_t first, uint32_t count,
                          uint32_t most, uint32_t& next) {
  if (count > most || !view.filters.holds(next, count)) return AXISRT_OUT_OF_BOUNDS;
  if (count > 0 && first != next) return AXISRT_OUT_OF_BOUNDS;
  for (uint32_t i = 0; i < count; ++i) {
    Record<record::filter> const filter = view.filters[next + i];
    if (filter[field::filter::axis] != axis) return AXISRT_OUT_OF_BOUNDS;
    if (filter[field::filter::port] != port) return AXISRT_OUT_OF_BOUNDS;
    bool const ascends =
        i == 0 || filter[field::filter::index] > view.filters[next + i - 1][field::filter::index];
    if (!ascends || filter[field::filter::index] >= axim_most_filters) return AXISRT_OUT_OF_BOUNDS;
  }
  next += count;
  return AXISRT_OK;
}

axisrt_status check_contents(ImageView const& view) {
  return first_failure(
      [&] { return check_cycle_time(view.header()); },
      // Before the proofs: an unstable filter has none that could be true.
      [&] {
        return check_each(view.coefficients, [](auto section, uint32_t) { return check_section(section); });
      },
      [&] {
        return check_each(view.filters, [&](auto filter, uint32_t) { return check_filter(view, filter); });
      },
      [&] { return check_axes_and_chains(view); }, [&] { return check_kernels(view); },
      [&] { return check_bound_records(view); },
      [&] { return check_each(view.self_tests, [](auto sample, uint32_t) { return check_sample(sample); }); },
      [&] { return check_each(view.lists, [&](auto list, uint32_t) { return check_list(view, list); }); },
      [&] {
        return check_each(view.values, [&](auto value, uint32_t) { return check_value(view, value); });
      });
}

axisrt_status verify_image(void const* image, size_t size, ImageView& view) {
  return in_plain_arithmetic([&] {
    axisrt_status const status = open_image(image, size, view);
    return status == AXISRT_OK ? check_contents(view) : status;
  });
}

}  // namespace axisc::runtime

axisrt_status axisrt_verify(void const* image, size_t size) {
  axisc::runtime::ImageView view;
  return axisc::runtime::verify_image(image, size, view);
}
