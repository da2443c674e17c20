// From a specification to second-order sections (or a pure delay), with the figures that engineers ask for.
//
// Transfer functions are written  H(z) = (b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2).
// Sections are handed on in increment form (spec "filter mathematics", realisation), because direct forms in
// double lose seven digits at low frequencies and large positions.
#pragma once

#include "design/filter_specification.hpp"

#include <complex>
#include <cstdint>
#include <utility>
#include <vector>

namespace axisc::design {

/// One second-order section in increment form, each coefficient rounded once.
///     k = 1 + a1 + a2,  b = 1 - a2
/// H(1) = 1:  H - 1 = (p + q z^-1)(1 - z^-1)/A,  p = b0 - 1, q = p + b1 - a1
/// H(1) = 0:  H     = (p + q z^-1)(1 - z^-1)/A,  p = b0,     q = b0 + b1      (blocks_constant)
struct IncrementSection {
  double p = 0;
  double q = 0;
  double k = 0;
  double b = 0;
  friend constexpr bool operator==(IncrementSection const&, IncrementSection const&) = default;
};

/// The section in textbook form, in double, for display only.
struct DirectSection {
  double b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
};

enum class Realisation : std::uint8_t {
  pass_through = 0,  ///< H(z) = 1
  sections = 1,
  delay = 2,  ///< H(z) = z^-delay_cycles
};

/// out = share·H(x) + (1 - share)·x. `direct` + `direct_low` is 1 - share in twice the precision of double.
struct Share {
  double filtered = 1;
  double direct = 0;
  double direct_low = 0;
};

struct FilterDesign {
  Realisation realisation = Realisation::pass_through;
  std::vector<IncrementSection> sections{};  ///< by rising pole radius
  bool blocks_constant = false;              ///< every section has H(1) = 0 (high-pass and band-pass)
  std::uint32_t delay_cycles = 0;            ///< for Realisation::delay
  Share share{};

  double pole_radius = 0;  ///< largest |pole|, 0 where there is none; 1 where rounding the coefficients
                           ///< moved a pole onto the unit circle (frequencies next to 0 or 0.5/T)
  double dc_gain = 1;      ///< with the share
  double group_delay_cycles = 0;  ///< at 0 Hz, with the share, in NC cycles; negative where a share lets a
                                  ///< high- or band-pass lead; 0 where dc_gain is 0
};

/// Double is quick and enough for rules; exact works with 50 decimal digits and rounds once, for images.
enum class Precision : std::uint8_t { quick, exact };

/// A pure function: equal arguments give equal designs, for Precision::exact on every host.
/// A share of 0 % and a delay of 0 pass through. Expects a specification within its ranges.
/// Cost: up to 10 µs quick, 0.2 ms exact.
[[nodiscard]] FilterDesign design_filter(FilterSpecification const& specification, CycleTime cycle_time,
                                         Precision precision);

/// A runtime accepts it (axisrt_verify): poles inside the unit circle, and numerators of moderate size.
[[nodiscard]] bool is_loadable(IncrementSection const& section);

/// About the largest error that rounding of the coefficients makes in the frequency response. Poles close to
/// -1 make it large: their A(-1) = 4 - k - 2b is a small difference of large numbers. Infinite where a
/// section is not loadable.
[[nodiscard]] double rounding_error(FilterDesign const& filter);

/// Display form of a section.
[[nodiscard]] DirectSection direct_form(IncrementSection const& section, bool blocks_constant);
/// Its poles (a pair, or one real pole and 0 for a first-order section).
[[nodiscard]] std::pair<std::complex<double>, std::complex<double>> poles(IncrementSection const& section);

}  // namespace axisc::design
