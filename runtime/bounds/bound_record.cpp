#include "runtime/bounds/bound_record.hpp"

#include "runtime/bounds/outward.hpp"
#include "runtime/bounds/rounding.hpp"
#include "runtime/bounds/standstill.hpp"

namespace axisc::runtime::bounds {
namespace {

/// Of the enclosure of a gain, for every unit of it; a wider one is computed again, and better.
constexpr double widest = 0x1p-30;

/// No filter multiplies anything: sums of 0 and 1.
bool is_exact(Chain const& chain, KernelPart const& kernel) {
  bool exact = chain.section_count == 0 && kernel.count == 0;
  for (uint32_t i = 0; i < chain.filter_count; ++i) exact = exact && !chain.filters[i].is_shared();
  return exact;
}

/// Errors of the sums of |h| and of |s - H(1)|.
struct RunErrors {
  double gain, distance;
};

/// Those of follow_response. 0 where nothing was rounded.
RunErrors errors_of_run(Chain const& chain, KernelPart const& kernel, Response const& run) {
  if (is_exact(chain, kernel)) return {};
  Passing const before{.sum = kernel.tail_sum, .d = kernel.tap_sum};
  auto const error = [&](Target target) {
    RoundingOfFilters const filters =
        rounding_of_filters(chain, run.sections, before, &Size::increment, target);
    return filters.error + unit_roundoff * second_order * kernel.tap_sum * filters.gain_of_d;
  };
  return {.gain = error({0, 1}), .distance = error({1, 0})};
}

/// Those of repeat_response, which loses of what was lost only: an operation rounds at most five times, each
/// time by u times the size of that, or of what is added to it (u times what is in `first`).
RunErrors errors_of_repeated(Chain const& chain, KernelPart const& kernel, Response const& repeated,
                             RunErrors first) {
  constexpr double roundings = 8;
  Passing const before{.sum = 0, .d = unit_roundoff * kernel.tap_sum};
  auto const error = [&](Target target, double added) {
    RoundingOfFilters const filters =
        rounding_of_filters(chain, repeated.sections, before, &Size::increment, target);
    return roundings * (filters.error + roundings * unit_roundoff * added);
  };
  return {.gain = error({0, 1}, first.gain), .distance = error({1, 0}, first.distance)};
}

struct States {
  double increment, position;
};

States largest_states(Chain const& chain, SectionSizes const* sizes) {
  States largest{};
  for (uint32_t i = 0; i < chain.section_count; ++i) {
    largest.increment = larger(largest.increment, larger(sizes[i].e.increment, sizes[i].r.increment));
    largest.position = larger(largest.position, larger(sizes[i].e.position, sizes[i].r.position));
  }
  return largest;
}

double largest_radius(Chain const& chain) {
  double radius = 0;
  for (uint32_t i = 0; i < chain.section_count; ++i) {
    radius = larger(radius, chain.sections[i].radius);
  }
  return radius;
}

}  // namespace

double limit_of_axis(ImageView const& view, uint32_t axis) {
  double const T = view.header()[field::header::cycle_time_ns] * 1e-9;
  return view.axes[axis][field::axis::velocity_limit] * 10 * T;
}

void BoundComputation::read_filters(BoundKey const& key) {
  if (key_.axis == key.axis && key_.port == key.port && key_.stage == key.stage) return;
  key_ = key;
  FilterRange const filters = filters_of(view_, key);
  read_chain(view_, filters.first, filters.count, chain_);
  follow_response(chain_, read_kernel(view_, AXIM_NONE, false), alone_);
}

void BoundComputation::compute(BoundKey const& key, BoundRecord& record) {
  read_filters(key);
  KernelPart const kernel = read_kernel(view_, key.kernel, has_kernel_before(view_, key.axis));
  if (kernel.count > 0) follow_response(chain_, kernel, joint_);
  Response const& run = kernel.count > 0 ? joint_ : alone_;
  bool const is_tight = run.ended && chain_.is_certain;

  record = {};
  record.flags = is_tight ? 0 : axim_bound_majorant;
  record.cycles = run.cycles;
  record.radius_high = largest_radius(chain_);
  add_response(kernel, run, record);
  if (chain_.is_certain) add_arithmetic(kernel, run, record);
  set_place(view_, key, record);
}

void BoundComputation::add_response(KernelPart const& kernel, Response const& run, BoundRecord& record) {
  RunErrors errors = errors_of_run(chain_, kernel, run);
  bool const is_wide = run.ended && 2 * errors.gain > widest * run.gain;
  if (is_wide) {
    repeat_response(chain_, kernel, run.cycles, repeated_);
    errors = errors_of_repeated(chain_, kernel, repeated_, errors);
  }
  Response const& sums = is_wide ? repeated_ : run;
  // Of the sums themselves.
  constexpr double of_sums = 4 * unit_roundoff;
  if (!is_exact(chain_, kernel)) {
    errors.gain += of_sums * sums.gain;
    errors.distance += of_sums * sums.distance;
  }
  record.gain_low = below(sums.gain, errors.gain);
  record.gain_high = above(sums.gain, errors.gain + sums.gain_rest);
  double const left = errors.distance + sums.distance_rest;
  if (chain_.final_value == 1) record.distance_high = above(sums.distance, left);
  if (chain_.final_value > 0) {
    record.overshoot_high = above(larger(sums.highest, 0) / chain_.final_value, left / chain_.final_value);
  }
}

void BoundComputation::add_arithmetic(KernelPart const& kernel, Response const& run,
                                      BoundRecord& record) const {
  SectionSizes const* const executed = kernel.is_before ? run.sections : alone_.sections;
  record.rounding_increment = above(0, rounding_error(chain_, kernel, alone_, run, &Size::increment));
  record.rounding_position = above(0, rounding_error(chain_, kernel, alone_, run, &Size::position));
  States const states = largest_states(chain_, executed);
  record.state_increment = above(0, states.increment * second_order);
  record.state_position = above(0, states.position * second_order);
  if (record.flags == 0) record.rest_cycles = rest_cycles(chain_, executed, kernel);
}

void set_place(ImageView const& view, BoundKey const& key, BoundRecord& record) {
  record.axis = key.axis;
  record.port = key.port;
  record.kernel = key.kernel;
  record.stage = key.stage;
  bool const has_limit = key.port == axim_port_setpoint;
  record.limit_error = has_limit ? above(0, record.rounding_increment * limit_of_axis(view, key.axis)) : 0;
}

}  // namespace axisc::runtime::bounds
