// The building blocks of the checks of an image.
#pragma once

#include "axisrt.h"
#include "runtime/double_bits.hpp"
#include "runtime/verification/image_view.hpp"

#include <stdint.h>

namespace axisc::runtime {

template <class... Numbers>
[[nodiscard]] axisrt_status check_finite(Numbers... numbers) {
  return (is_finite(numbers) && ...) ? AXISRT_OK : AXISRT_NOT_FINITE;
}

template <class... Conditions>
[[nodiscard]] axisrt_status check_bounds(Conditions... conditions) {
  return (conditions && ...) ? AXISRT_OK : AXISRT_OUT_OF_BOUNDS;
}

/// The first check that fails decides.
template <class... Checks>
[[nodiscard]] axisrt_status first_failure(Checks... checks) {
  axisrt_status status = AXISRT_OK;
  (void)(((status = checks()) == AXISRT_OK) && ...);
  return status;
}

/// The first record that fails decides; `check` gets the record and its index.
template <class RecordType, class Check>
[[nodiscard]] axisrt_status check_each(Table<RecordType> const& table, Check check) {
  for (uint32_t i = 0; i < table.count; ++i) {
    axisrt_status const status = check(table[i], i);
    if (status != AXISRT_OK) return status;
  }
  return AXISRT_OK;
}

/// Record of an axis in a table that is sorted by its field `axis`; the number of records where the axis has
/// none.
template <class RecordType, size_t Offset>
[[nodiscard]] uint32_t find_axis(Table<RecordType> const& table, Field<RecordType, uint32_t, Offset> field,
                                 uint32_t axis) {
  uint32_t begin = 0;
  uint32_t end = table.count;
  while (begin < end) {
    uint32_t const middle = begin + (end - begin) / 2;
    if (table[middle][field] < axis) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin < table.count && table[begin][field] == axis ? begin : table.count;
}

/// The sum of |h| is never below |H(1)|. A compiler whose sums were not rounded upwards may have stored a
/// little less.
[[nodiscard]] inline bool is_possible_gain(double peak_gain, double gain_at_zero) {
  return peak_gain > 0 && peak_gain >= gain_at_zero * (1 - 0x1p-20);
}

/// Samples of a self-test are within their section.
[[nodiscard]] inline axisrt_status check_samples(ImageView const& view, uint32_t first, uint32_t count) {
  return check_bounds(count <= axim_most_samples, count == 0 || view.self_tests.holds(first, count));
}

/// Kernels, slots, groups and banks.
[[nodiscard]] axisrt_status check_kernels(ImageView const& view);
/// The section `bounds`: complete, in order, and possible.
[[nodiscard]] axisrt_status check_bound_records(ImageView const& view);
/// Improved Position Control; `next_filter` is the first filter that no chain of an axis has claimed.
[[nodiscard]] axisrt_status check_controls(ImageView const& view, uint32_t& next_filter);
/// Filters of one chain are consecutive, beginning at `next`, which is moved past them.
[[nodiscard]] axisrt_status check_chain(ImageView const& view, uint32_t axis, uint32_t port, uint32_t first,
                                        uint32_t count, uint32_t most, uint32_t& next);

}  // namespace axisc::runtime
