// The specification of a standard filter, in terms of the axis list (manual "axis filters", sections 2.1 and
// 3).
#pragma once

#include "design/readings.hpp"
#include "design/units.hpp"

#include <cstdint>

namespace axisc::design {

/// Values are the numbers of P-AXIS-00204.
enum class FilterType : std::uint8_t {
  lowpass = 1,
  highpass = 2,
  bandpass = 3,
  bandstop = 4,
  allpass = 5,
  pt1 = 6,
  pt2 = 10,
  time_delay = 11,
};

/// Values are the numbers of P-AXIS-00153.
enum class Prototype : std::uint8_t { critical_damping = 1, butterworth = 2, bessel = 3 };

/// The type's row in design/filter_kinds.hpp defines which of the values it uses, and in which ranges.
/// design_filter() expects them to hold, and share_percent 0..100.
struct FilterSpecification {
  FilterType type = FilterType::lowpass;
  Prototype prototype = Prototype::critical_damping;
  std::uint32_t order = 1;
  Hertz frequency{30};
  double quality = 1;
  Microseconds time_constant{10000};
  double share_percent = 100;
  FilterReading reading = FilterReading::documented;  ///< see applied_reading()
  CycleReading cycle_time = CycleReading::documented;

  friend constexpr bool operator==(FilterSpecification const&, FilterSpecification const&) = default;
};

/// The specification's reading, or `documented` where that one means nothing for the filter: for a time delay
/// every one, matched poles where the constant part is blocked (the gain could not be normalised),
/// poles_at_frequency for anything but a low-, high- or all-pass of critical damping above order 1, and so
/// on.
[[nodiscard]] FilterReading applied_reading(FilterSpecification const& specification);

}  // namespace axisc::design
