// Units of filter design as types of their own; conversions stand here and nowhere else.
#pragma once

#include <compare>
#include <cstdint>

namespace axisc::design {

struct Hertz {
  double value = 0;
  friend constexpr auto operator<=>(Hertz const&, Hertz const&) = default;
};

struct Microseconds {
  double value = 0;
  friend constexpr auto operator<=>(Microseconds const&, Microseconds const&) = default;
};

/// NC cycle time T. Kept in whole nanoseconds, so that equal machines have equal images.
struct CycleTime {
  std::uint32_t nanoseconds = 1'000'000;

  [[nodiscard]] constexpr double microseconds() const { return nanoseconds / 1e3; }
  [[nodiscard]] constexpr double seconds() const { return nanoseconds / 1e9; }
  /// 0.5/T: what a characteristic frequency must stay below.
  [[nodiscard]] constexpr Hertz nyquist() const { return {0.5e9 / nanoseconds}; }
  /// A time as a number of cycles.
  [[nodiscard]] constexpr double cycles(Microseconds time) const { return time.value * 1e3 / nanoseconds; }
  friend constexpr auto operator<=>(CycleTime const&, CycleTime const&) = default;
};

}  // namespace axisc::design
