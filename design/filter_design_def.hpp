// The whole way from specification to rounded sections in one number type. Included by the sources that
// instantiate it: quick in double, exact in extended precision.
#pragma once

#include "design/filter_design.hpp"
#include "design/pi_def.hpp"
#include "design/prototypes_def.hpp"
#include "design/section_def.hpp"
#include "design/thiran_def.hpp"
#include "design/transformations_def.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace axisc::design {

/// A delay this close to whole cycles is a pure delay.
inline constexpr double integer_delay_tolerance = 1e-9;

[[nodiscard]] constexpr bool blocks_constant(FilterType type) {
  return type == FilterType::highpass || type == FilterType::bandpass;
}

/// t = tan(π f T), the pre-warped characteristic frequency as the bilinear transform needs it.
template <typename Number>
[[nodiscard]] Number prewarped(Hertz frequency, CycleTime cycle_time) {
  using std::tan;
  return tan(pi<Number>() * cycle_time.periods_in<Number>(frequency));
}

/// The same for the cut-off frequency 1/(2π τ): t = tan(T/(2 τ)).
template <typename Number>
[[nodiscard]] Number prewarped(Microseconds time_constant, CycleTime cycle_time) {
  using std::tan;
  return tan(1 / (2 * cycle_time.cycles_in<Number>(time_constant)));
}

/// Q_a = sin(2π f0 T)/(2 tan(π (f0/Q) T)) puts the digital -3 dB edges f0/Q apart; sin 2α = 2 tan α/(1 + tan²
/// α).
template <typename Number>
[[nodiscard]] Number analogue_quality(FilterSpecification const& specification, CycleTime cycle_time,
                                      Number const& t) {
  using std::tan;
  Number const bandwidth =
      cycle_time.periods_in<Number>(specification.frequency) / Number(specification.quality);
  return t / ((1 + t * t) * tan(pi<Number>() * bandwidth));
}

template <typename Number>
[[nodiscard]] std::vector<Section<Number>> frequency_sections(FilterSpecification const& specification,
                                                              CycleTime cycle_time) {
  auto const poles = prototype_poles<Number>(specification.prototype, specification.order);
  auto const t = prewarped<Number>(specification.frequency, cycle_time);
  switch (specification.type) {
    case FilterType::highpass:
      return highpass(poles, t);
    case FilterType::allpass:
      return allpass(poles, t);
    case FilterType::bandpass:
      return bandpass(poles, analogue_quality(specification, cycle_time, t), t);
    case FilterType::bandstop:
      return bandstop(poles, analogue_quality(specification, cycle_time, t), t);
    default:
      return lowpass(poles, t);
  }
}

/// PT1 and PT2: poles at -1/τ.
template <typename Number>
[[nodiscard]] std::vector<Section<Number>> lag_sections(std::uint32_t order, Microseconds time_constant,
                                                        CycleTime cycle_time) {
  return lowpass(Poles<Number>(order, {Number(-1), Number(0)}), prewarped<Number>(time_constant, cycle_time));
}

/// What the image's loader demands of the stored numbers.
[[nodiscard]] inline bool is_stable(IncrementSection const& section) {
  return section.k > 0 && section.b > 0 && section.b < 2 && 4 - section.k - 2 * section.b > 0;
}

/// Orders the sections by rising pole radius and rounds each coefficient once.
template <typename Number>
void store_sections(std::vector<Section<Number>> const& sections, FilterDesign& design) {
  struct Entry {
    double radius;
    IncrementSection section;
  };
  std::vector<Entry> entries;
  for (auto const& section : sections) {
    IncrementSection const rounded{.p = static_cast<double>(section.p),
                                   .q = static_cast<double>(section.q),
                                   .k = static_cast<double>(section.k),
                                   .b = static_cast<double>(section.b)};
    // Poles that rounding moved onto or across the unit circle count as lying on it.
    entries.push_back({is_stable(rounded) ? static_cast<double>(pole_radius(section)) : 1.0, rounded});
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](Entry const& x, Entry const& y) { return x.radius < y.radius; });
  design.realisation = Realisation::sections;
  for (Entry const& entry : entries) design.sections.push_back(entry.section);
  design.pole_radius = entries.back().radius;
}

/// dH/d(jω) at ω = 0: the sum of the sections' slopes, or 0 where several sections block the constant part.
template <typename Number>
[[nodiscard]] Number slope_at_zero(std::vector<Section<Number>> const& sections, bool blocks) {
  if (blocks) return sections.size() == 1 ? sections.front().slope : Number(0);
  Number slope{0};
  for (auto const& section : sections) slope += section.slope;
  return slope;
}

template <typename Number>
[[nodiscard]] FilterDesign design_in(FilterSpecification const& specification, CycleTime cycle_time) {
  using std::abs;
  using std::floor;
  FilterDesign design;
  Number const share = Number(specification.share_percent) / 100;
  if (share == 0) return design;
  Number const direct = 1 - share;
  design.share.filtered = static_cast<double>(share);
  design.share.direct = static_cast<double>(direct);
  design.share.direct_low = static_cast<double>(Number(direct - Number(design.share.direct)));
  design.blocks_constant = blocks_constant(specification.type);

  Number slope{0};
  if (specification.type == FilterType::time_delay) {
    auto const D = cycle_time.cycles_in<Number>(specification.time_constant);
    Number const whole = floor(D + Number(0.5));
    if (abs(D - whole) <= Number(integer_delay_tolerance)) {
      if (whole == 0) return {};
      design.realisation = Realisation::delay;
      design.delay_cycles = static_cast<std::uint32_t>(static_cast<double>(whole));
      slope = -whole;
    } else {
      auto const sections = thiran(D);
      store_sections(sections, design);
      slope = slope_at_zero(sections, false);
    }
  } else {
    auto const sections = uses_frequency(specification.type)
                              ? frequency_sections<Number>(specification, cycle_time)
                          : specification.type == FilterType::pt1
                              ? lag_sections<Number>(1, specification.time_constant, cycle_time)
                              : lag_sections<Number>(2, specification.time_constant, cycle_time);
    store_sections(sections, design);
    slope = slope_at_zero(sections, design.blocks_constant);
  }

  Number const dc_gain = design.blocks_constant ? direct : Number(1);
  design.dc_gain = static_cast<double>(dc_gain);
  design.group_delay_cycles = dc_gain == 0 ? 0.0 : static_cast<double>(Number(-share * slope / dc_gain));
  return design;
}

}  // namespace axisc::design
