// The whole way from specification to rounded sections in one number type. Included by the sources that
// instantiate it: quick in double, exact in extended precision.
#pragma once

#include "design/filter_design.hpp"
#include "design/filter_kinds.hpp"
#include "design/filter_realisations_def.hpp"
#include "design/section_def.hpp"

#include <algorithm>
#include <vector>

namespace axisc::design {

/// The image loader's requirements on the stored numbers.
[[nodiscard]] inline bool is_stable(IncrementSection const& section) {
  return section.k > 0 && section.b > 0 && section.b < 2 && 4 - section.k - 2 * section.b > 0;
}

/// Largest |pole| of a section as it is stored, computed like one that is not rounded.
template <typename Number>
[[nodiscard]] double stored_pole_radius(IncrementSection const& section) {
  // Poles that rounding moved onto or across the unit circle count as lying on it.
  if (!is_stable(section)) return 1;
  return static_cast<double>(pole_radius(Section<Number>{.k = Number(section.k), .b = Number(section.b)}));
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
    entries.push_back({is_stable(rounded) ? static_cast<double>(pole_radius(section)) : 1.0, rounded});
    design.pole_radius = std::max(design.pole_radius, stored_pole_radius<Number>(rounded));
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](Entry const& x, Entry const& y) { return x.radius < y.radius; });
  design.realisation = Realisation::sections;
  for (Entry const& entry : entries) design.sections.push_back(entry.section);
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
  FilterDesign design;
  Number const share = Number(specification.share_percent) / 100;
  if (share == 0) return design;
  Number const direct = 1 - share;
  design.share.filtered = static_cast<double>(share);
  design.share.direct = static_cast<double>(direct);
  design.share.direct_low = static_cast<double>(Number(direct - Number(design.share.direct)));
  design.blocks_constant = kind_of(specification.type).blocks_constant;

  FilterRealisation<Number> const made = realise<Number>(specification, cycle_time);
  Number slope{0};
  if (!made.sections.empty()) {
    store_sections(made.sections, design);
    slope = slope_at_zero(made.sections, design.blocks_constant);
  } else {
    if (made.delay_cycles == 0) return {};
    design.realisation = Realisation::delay;
    design.delay_cycles = made.delay_cycles;
    slope = -Number(made.delay_cycles);
  }

  Number const dc_gain = design.blocks_constant ? direct : Number(1);
  design.dc_gain = static_cast<double>(dc_gain);
  design.group_delay_cycles = dc_gain == 0 ? 0.0 : static_cast<double>(Number(-share * slope / dc_gain));
  return design;
}

}  // namespace axisc::design
