// The oscillator in one number type. Included by the sources that instantiate it.
#pragma once

#include "design/filter_design_def.hpp"
#include "design/oscillator.hpp"

namespace axisc::design {

/// 1/(1 + 2 D s + s^2) = 1 - (2 D s + s^2)/(1 + 2 D s + s^2), s normalised to the pre-warped frequency.
template <typename Number>
[[nodiscard]] FilterDesign oscillator_in(OscillatorSpecification const& specification, CycleTime cycle_time) {
  Number const twice_damping = 2 * Number(specification.damping);
  Denominator<Number> const c{Number(1), twice_damping, Number(1), false};
  Numerator<Number> const n{-twice_damping, Number(-1)};
  Section<Number> const section = bilinear(c, n, prewarped<Number>(specification.frequency, cycle_time));
  FilterDesign design;
  store_sections(std::vector<Section<Number>>{section}, design);
  design.group_delay_cycles = static_cast<double>(Number(-section.slope));
  return design;
}

}  // namespace axisc::design
