#include "runtime/self_test.hpp"

#include "runtime/double_bits.hpp"
#include "runtime/reset.hpp"

namespace axisc::runtime {
namespace {

constexpr Signal rest{.base = 0, .sum = 0, .d = 0};

/// Distance from |value| to the next larger double.
double ulp(double value) {
  uint64_t const bits = magnitude_bits(value);
  return std::bit_cast<double>(bits + 1) - std::bit_cast<double>(bits);
}

double largest_input(ImageView const& view, uint32_t first, uint32_t count) {
  double largest = 0;
  for (uint32_t i = 0; i < count; ++i) {
    double const input = magnitude(view.self_tests[first + i][field::sample::input]);
    if (input > largest) largest = input;
  }
  return largest;
}

/// Runs samples through `step`, which takes a signal and gives one.
template <class Step>
bool passes(ImageView const& view, uint32_t first, uint32_t count, Step step) {
  double const tolerance = 2 * ulp(largest_input(view, first, count));
  double previous = 0;
  bool passed = true;
  for (uint32_t i = 0; i < count; ++i) {
    Record<record::sample> const sample = view.self_tests[first + i];
    double const input = sample[field::sample::input];
    double const output = value_of(step({.base = input, .sum = 0, .d = input - previous}));
    previous = input;
    passed = passed && is_within(output - sample[field::sample::output], tolerance);
  }
  return passed;
}

bool passes(ImageView const& view, Record<record::filter> record, Filter const& filter) {
  reset_filter(filter, rest);
  bool const passed = passes(view, record[field::filter::first_sample], record[field::filter::sample_count],
                             [&](Signal const& in) { return run_filter(filter, in); });
  reset_filter(filter, rest);
  return passed;
}

bool passes(ImageView const& view, Record<record::kernel> record, Slot const& slot, Kernel const& kernel) {
  Kernel const* const switched = slot.state->to;
  switch_slot(slot, &kernel, 0);
  reset_slot(slot);
  bool const passed = passes(view, record[field::kernel::first_sample], record[field::kernel::sample_count],
                             [&](Signal const& in) { return run_slot(slot, in); });
  switch_slot(slot, switched, 0);
  reset_slot(slot);
  return passed;
}

/// The first slot whose history is long enough; null where no slot executes so long a kernel.
Slot const* slot_for(axisrt const& runtime, Kernel const& kernel) {
  for (uint32_t i = 0; i < runtime.slot_count; ++i) {
    if (runtime.slots[i].history_length >= kernel.tail_count) return runtime.slots + i;
  }
  return nullptr;
}

}  // namespace

axisrt_status run_self_tests(ImageView const& view, axisrt const& runtime) {
  for (uint32_t i = 0; i < view.filters.count; ++i) {
    if (!passes(view, view.filters[i], runtime.filters[i])) return AXISRT_SELF_TEST_FAILED;
  }
  for (uint32_t i = 0; i < view.kernels.count; ++i) {
    Kernel const& kernel = runtime.kernels[i];
    Slot const* const slot = slot_for(runtime, kernel);
    if (slot != nullptr && !passes(view, view.kernels[i], *slot, kernel)) return AXISRT_SELF_TEST_FAILED;
  }
  return AXISRT_OK;
}

}  // namespace axisc::runtime
