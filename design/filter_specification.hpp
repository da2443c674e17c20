// What a standard filter shall do, in the words of the axis list (manual "axis filters", sections 2.1 and 3).
#pragma once

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

/// Ranges are those of spec and manual; design_filter() expects them to hold:
/// order 1..6 (low-, high-, all-pass) or 1..3 (band filters), ignored by PT1, PT2 and TIME_DELAY;
/// 0 < frequency < 0.5/T where the type uses it; quality 1..10 for band filters;
/// time_constant ≥ T for PT1 and PT2, 0 ≤ time_constant < 6 T for TIME_DELAY; share_percent 0..100.
struct FilterSpecification {
  FilterType type = FilterType::lowpass;
  Prototype prototype = Prototype::critical_damping;
  std::uint32_t order = 1;
  Hertz frequency{30};
  double quality = 1;
  Microseconds time_constant{10000};
  double share_percent = 100;

  friend constexpr bool operator==(FilterSpecification const&, FilterSpecification const&) = default;
};

[[nodiscard]] constexpr bool uses_frequency(FilterType type) {
  return type <= FilterType::allpass;
}
[[nodiscard]] constexpr bool uses_prototype(FilterType type) {
  return type <= FilterType::allpass;
}
[[nodiscard]] constexpr bool uses_quality(FilterType type) {
  return type == FilterType::bandpass || type == FilterType::bandstop;
}
[[nodiscard]] constexpr bool uses_time_constant(FilterType type) {
  return type >= FilterType::pt1;
}
[[nodiscard]] constexpr bool computes_order(FilterType type) {
  return type >= FilterType::pt1;
}

}  // namespace axisc::design
