// The parameters of one standard filter, seen together: filter[i] or lr_param.add_interface.filter[i].
#pragma once

#include "design/filter_kinds.hpp"
#include "validator/values/effective_values.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace axisc::validator {

enum class FilterPort : std::uint8_t { setpoint = 0, additional_interface = 1 };

/// References stay valid while the EffectiveValues live.
struct FilterView {
  FilterPort port;
  std::uint32_t index;
  EffectiveValue const& enable;
  EffectiveValue const& order;
  EffectiveValue const& prototype;
  EffectiveValue const& type;
  EffectiveValue const& frequency;
  EffectiveValue const& quality;
  EffectiveValue const& share;
  EffectiveValue const& time_constant;
  design::Readings readings;  ///< of the values
  /// The type as a standard filter; none for HSC and undocumented types, and with prototype HSC.
  std::optional<design::FilterType> standard_type;

  FilterView(EffectiveValues const& values, FilterPort port, std::uint32_t index);

  [[nodiscard]] std::array<EffectiveValue const*, 8> all() const {
    return {&enable, &order, &prototype, &type, &frequency, &quality, &share, &time_constant};
  }
  [[nodiscard]] bool is_hsc() const;  ///< prototype HSC
  /// Number of P-AXIS-00204: the configured type; if none is set, its default (8 with prototype HSC, else
  /// 1; PT2 for the additional interface).
  [[nodiscard]] int type_number() const;
  /// The symbol of the type, "LOWPASS".
  [[nodiscard]] std::string_view type_word() const;
  /// enable = 1 and order > 0, a standard type, and every value that decides this is usable.
  [[nodiscard]] bool active() const;
  /// The type is unknown: it is unusable, or its default depends on an unusable prototype.
  [[nodiscard]] bool type_unusable() const;
  /// Some parameter that decides type or activation could not be used.
  [[nodiscard]] bool unusable() const;
  /// The place of a finding about `wanted`: its value if a list sets it, else `enable`, else the
  /// first parameter of the filter that is set.
  [[nodiscard]] EffectiveValue const& anchor(EffectiveValue const& wanted) const;
  /// The specification of an active filter whose values are all in the ranges that design_filter() expects;
  /// none otherwise. Values that the type ignores keep the specification's own defaults, so that equal
  /// filters have equal specifications.
  [[nodiscard]] std::optional<design::FilterSpecification> specification(design::CycleTime cycle_time) const;
};

/// Every standard filter with at least one parameter that a list sets: filter[0..2], then those of the
/// additional interface.
[[nodiscard]] std::vector<FilterView> touched_filters(EffectiveValues const& values);

}  // namespace axisc::validator
