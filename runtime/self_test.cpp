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

bool passes(ImageView const& view, Filter const& filter, uint32_t first, uint32_t count) {
  double const tolerance = 2 * ulp(largest_input(view, first, count));
  double previous = 0;
  bool passed = true;
  reset_filter(filter, rest);
  for (uint32_t i = 0; i < count; ++i) {
    Record<record::sample> const sample = view.self_tests[first + i];
    double const input = sample[field::sample::input];
    double const output = value_of(run_filter(filter, {.base = input, .sum = 0, .d = input - previous}));
    previous = input;
    passed = passed && is_within(output - sample[field::sample::output], tolerance);
  }
  reset_filter(filter, rest);
  return passed;
}

}  // namespace

axisrt_status run_self_tests(ImageView const& view, Filter const* filters) {
  for (uint32_t i = 0; i < view.filters.count; ++i) {
    Record<record::filter> const record = view.filters[i];
    if (!passes(view, filters[i], record[field::filter::first_sample], record[field::filter::sample_count])) {
      return AXISRT_SELF_TEST_FAILED;
    }
  }
  return AXISRT_OK;
}

}  // namespace axisc::runtime
