// The damped oscillator by which Improved Position Control imitates a mechanical vibration
// (spec "filter mathematics", section 3):  H(s) = w0^2 / (s^2 + 2 D w0 s + w0^2), bilinear, pre-warped at f0.
#pragma once

#include "design/filter_design.hpp"
#include "design/units.hpp"

namespace axisc::design {

/// Ranges: 0 < frequency < 0.5/T, 0 < damping.
struct OscillatorSpecification {
  Hertz frequency{1};
  double damping = 1;  ///< D
  friend constexpr bool operator==(OscillatorSpecification const&, OscillatorSpecification const&) = default;
};

/// One second-order section with DC gain 1. As design_filter: for Precision::exact equal on every host.
[[nodiscard]] FilterDesign design_oscillator(OscillatorSpecification const& specification,
                                             CycleTime cycle_time, Precision precision);

}  // namespace axisc::design
