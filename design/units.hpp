// Units of filter design as types of their own; all conversions are here.
#pragma once

#include <compare>
#include <cstdint>

namespace axisc::design {

struct Hertz {
  double value = 0;
  friend constexpr auto operator<=>(Hertz const&, Hertz const&) = default;  // NOLINT(modernize-use-nullptr)
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
  /// 0.5/T: the limit of characteristic frequencies.
  [[nodiscard]] constexpr Hertz nyquist() const { return {0.5e9 / nanoseconds}; }
  /// A time as a number of cycles.
  [[nodiscard]] constexpr double cycles(Microseconds time) const { return cycles_in<double>(time); }
  template <typename Number>
  [[nodiscard]] constexpr Number cycles_in(Microseconds time) const {
    return Number(time.value) * 1000 / Number(nanoseconds);
  }
  /// f·T: the part of its period that a frequency advances in a cycle.
  template <typename Number>
  [[nodiscard]] constexpr Number periods_in(Hertz frequency) const {
    return Number(frequency.value) * Number(nanoseconds) / 1'000'000'000;
  }
  // NOLINT below: clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
  friend constexpr auto operator<=>(CycleTime const&,
                                    CycleTime const&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Lists give velocity limits in µm/s, programs feeds in mm/min.
inline constexpr double mm_per_min_of_um_per_s = 0.06;

/// NC cycle times that controls run with; a list or machine that asks for another one has mistaken the unit.
inline constexpr CycleTime shortest_cycle_time{20'000};
inline constexpr CycleTime longest_cycle_time{100'000'000};
[[nodiscard]] constexpr bool is_possible(CycleTime time) {
  return time >= shortest_cycle_time && time <= longest_cycle_time;
}

}  // namespace axisc::design
