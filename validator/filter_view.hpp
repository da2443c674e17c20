// The parameters of one standard filter, seen together: filter[i] or lr_param.add_interface.filter[i].
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "design/filter_specification.hpp"
#include "validator/effective_values.hpp"

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

  FilterView(EffectiveValues const& values, FilterPort port, std::uint32_t index);

  [[nodiscard]] std::array<EffectiveValue const*, 8> all() const {
    return {&enable, &order, &prototype, &type, &frequency, &quality, &share, &time_constant};
  }
  /// A list sets at least one of the parameters.
  [[nodiscard]] bool touched() const;
  [[nodiscard]] bool is_hsc() const;        ///< prototype HSC
  /// Number of P-AXIS-00204: the configured type; where none is set, its default (8 with prototype HSC, else 1; PT2 for the
  /// additional interface).
  [[nodiscard]] int type_number() const;
  /// The type as a standard filter; none for HSC and undocumented types.
  [[nodiscard]] std::optional<design::FilterType> standard_type() const;
  /// enable = 1 and order > 0 (and a standard type).
  [[nodiscard]] bool active() const;
  /// Some parameter that decides type or activation could not be used.
  [[nodiscard]] bool unusable() const;
  /// Where a finding about `wanted` stands: at its value where a list sets it, else at `enable`, else at the first
  /// parameter of the filter that is set.
  [[nodiscard]] EffectiveValue const& anchor(EffectiveValue const& wanted) const;
  /// The specification of an active filter whose values are all in range; none otherwise. Without range the design is undefined.
  [[nodiscard]] std::optional<design::FilterSpecification> specification(design::CycleTime cycle_time) const;
};

}  // namespace axisc::validator
