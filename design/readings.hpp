// How a control computes its filters where the manuals leave it open. By default axisc uses the reading
// `documented`; a comparison with a recording (analysis/comparison/) finds out which one a control has.
#pragma once

#include "design/units.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace axisc::design {

/// Readings of standard filters. The numbers are stored in images.
enum class FilterReading : std::uint8_t {
  documented =
      0,  ///< bilinear transform with pre-warping, -3 dB at fg_f0, quality between the digital -3 dB edges
  no_prewarping,           ///< bilinear transform without pre-warping
  backward_euler,          ///< s = (1 - z^-1)/T
  forward_euler,           ///< s = (1 - z^-1)/(T z^-1)
  matched,                 ///< poles and zeros z = exp(s T), zeros at infinity become -1; gain 1 at 0 Hz
  matched_poles,           ///< the same without zeros for those at infinity
  poles_at_frequency,      ///< critical damping: all poles at fg_f0 instead of -3 dB there
  analogue_quality,        ///< the quality is that of the analogue filter
  half_gain_at_frequency,  ///< low- and high-passes: -6 dB at fg_f0
  quality_of_poles,  ///< bands of critical damping: the quality is that of the poles, not fg_f0 by bandwidth
  bessel_delay,      ///< Bessel filters: a delay of 1/(2π fg_f0) at rest
  allpass_phase,     ///< all-passes turn the phase by half of its whole angle at fg_f0
};

/// Readings of linear-phase kernels. The numbers are stored in images.
enum class KernelReading : std::uint8_t {
  documented = 0,           ///< see design/kernels/kernel_design.hpp
  taps_n,                   ///< order N means N taps
  taps_n_plus_1,            ///< order N means N + 1 taps
  half_width_rounded_down,  ///< h = floor(N/2)
  order_is_half_width,      ///< h = N
  gaussian_width_1,         ///< σ = quality·h
  gaussian_width_2,         ///< σ = quality·h/2
  gaussian_width_3,         ///< σ = quality·h/3
  sinc_hann,                ///< window 0.5 + 0.5 cos(πk/h)
  sinc_blackman,            ///< window 0.42 + 0.5 cos(πk/h) + 0.08 cos(2πk/h)
  sinc_no_window,
  novib_one_box,    ///< one box of a period, not two convolved
  share_undelayed,  ///< the unfiltered share passes undelayed
  share_ignored,    ///< as with 100 %
  // Of Vibration Guard (design/vibration_guard.hpp):
  guard_rounded,           ///< each impulse on the nearest cycle, mode 4 from 0 on
  guard_rounded_up,        ///< each impulse on the next cycle, mode 4 from 0 on
  guard_zero_placed,       ///< taps that place a zero exactly on the oscillation
  guard_undamped_spacing,  ///< impulses half a period of the undamped frequency apart
  guard_quarters,          ///< mode 4: 1/4, 1/2, 1/4
  guard_uncentred,         ///< mode 4 from 0 on, split between cycles
};

/// Those of Vibration Guard by themselves, as settings name them.
enum class GuardReading : std::uint8_t {
  documented = 0,
  rounded,
  rounded_up,
  zero_placed,
  undamped_spacing,
  quarters,
  uncentred
};

/// Readings of the cycle time for which standard filters and kernels are computed.
enum class CycleReading : std::uint8_t { documented = 0, twice, half, fourfold, quarter };

/// One control's readings; those that mean nothing for a type leave it as documented.
struct Readings {
  FilterReading filters = FilterReading::documented;
  KernelReading kernels = KernelReading::documented;
  GuardReading guard = GuardReading::documented;
  CycleReading cycle_time = CycleReading::documented;

  friend constexpr bool operator==(Readings const&, Readings const&) = default;
};

/// From the analogue filter to the digital one.
enum class Discretisation : std::uint8_t { bilinear, backward_euler, forward_euler, matched, matched_poles };

/// By number: the words of settings, of `compare` and of `inspect`.
inline constexpr std::array<std::string_view, 12> filter_reading_words{
    "documented",    "no-prewarping",      "backward-euler",   "forward-euler",          "matched",
    "matched-poles", "poles-at-frequency", "analogue-quality", "half-gain-at-frequency", "quality-of-poles",
    "bessel-delay",  "allpass-phase"};
inline constexpr std::array<std::string_view, 20> kernel_reading_words{"documented",
                                                                       "taps-n",
                                                                       "taps-n-plus-1",
                                                                       "half-width-rounded-down",
                                                                       "order-is-half-width",
                                                                       "gaussian-width-1",
                                                                       "gaussian-width-2",
                                                                       "gaussian-width-3",
                                                                       "sinc-hann",
                                                                       "sinc-blackman",
                                                                       "sinc-no-window",
                                                                       "novib-one-box",
                                                                       "share-undelayed",
                                                                       "share-ignored",
                                                                       "rounded",
                                                                       "rounded-up",
                                                                       "zero-placed",
                                                                       "undamped-spacing",
                                                                       "quarter-half-quarter",
                                                                       "uncentred"};
/// Of FIR and HSC filters; those of Vibration Guard follow.
inline constexpr std::size_t linear_phase_readings = 14;
inline constexpr std::array<std::string_view, 5> cycle_reading_words{"documented", "double", "half",
                                                                     "fourfold", "quarter"};

[[nodiscard]] constexpr std::string_view word_of(FilterReading reading) {
  return filter_reading_words[static_cast<std::size_t>(reading)];
}
[[nodiscard]] constexpr std::string_view word_of(KernelReading reading) {
  return kernel_reading_words[static_cast<std::size_t>(reading)];
}
inline constexpr std::array<std::string_view, 7> guard_reading_words{
    "documented",           "rounded",  "rounded-up", "zero-placed", "undamped-spacing",
    "quarter-half-quarter", "uncentred"};

[[nodiscard]] constexpr std::string_view word_of(GuardReading reading) {
  return guard_reading_words[static_cast<std::size_t>(reading)];
}
/// The same reading among those of all kernels, whose numbers images have.
[[nodiscard]] constexpr KernelReading kernel_reading(GuardReading reading) {
  auto const number = static_cast<std::size_t>(reading);
  return static_cast<KernelReading>(number == 0 ? 0 : linear_phase_readings - 1 + number);
}
/// The reverse; documented for those of other kernels.
[[nodiscard]] constexpr GuardReading guard_reading(KernelReading reading) {
  auto const number = static_cast<std::size_t>(reading);
  bool const is_of_guards = number >= linear_phase_readings;
  return static_cast<GuardReading>(is_of_guards ? number + 1 - linear_phase_readings : 0);
}
static_assert(kernel_reading(GuardReading::uncentred) == KernelReading::guard_uncentred);

[[nodiscard]] constexpr std::string_view word_of(CycleReading reading) {
  return cycle_reading_words[static_cast<std::size_t>(reading)];
}

/// The reading of a word; none for an unknown word.
template <class Reading>
[[nodiscard]] constexpr std::optional<Reading> reading_of(std::span<std::string_view const> words,
                                                          std::string_view word) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == word) return static_cast<Reading>(i);
  }
  return std::nullopt;
}

/// The cycle time that filters are computed for, at least 1 ns.
[[nodiscard]] constexpr CycleTime as_read(CycleTime cycle_time, CycleReading reading) {
  switch (reading) {
    case CycleReading::twice: return CycleTime{2 * cycle_time.nanoseconds};
    case CycleReading::half: return CycleTime{(cycle_time.nanoseconds + 1) / 2};
    case CycleReading::fourfold: return CycleTime{4 * cycle_time.nanoseconds};
    case CycleReading::quarter: return CycleTime{(cycle_time.nanoseconds + 3) / 4};
    case CycleReading::documented: break;
  }
  return cycle_time;
}

}  // namespace axisc::design
