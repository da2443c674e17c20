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

/// Which of the values a type uses, and in which ranges, says its row in design/filter_kinds.hpp. design_filter()
/// expects them to hold, and share_percent 0..100.
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

}  // namespace axisc::design
