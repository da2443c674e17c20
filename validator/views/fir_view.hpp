// The parameters of an axis' FIR filter, seen together: filter_fir.
#pragma once

#include "design/kernels/kernel_design.hpp"
#include "validator/values/effective_values.hpp"

#include <cstdint>
#include <optional>

namespace axisc::validator {

/// Values are the numbers of P-AXIS-00586.
enum class FirType : std::uint8_t {
  none = 0,
  moving_average = 1,
  gaussian = 2,
  windowed_sinc = 3,
  time_delay = 4,
};

/// References stay valid while the EffectiveValues live.
struct FirView {
  EffectiveValue const& enable;
  EffectiveValue const& type;
  EffectiveValue const& order;
  EffectiveValue const& order_time;
  EffectiveValue const& share;
  EffectiveValue const& frequency;
  EffectiveValue const& quality;
  design::Readings readings;  ///< of the values

  explicit FirView(EffectiveValues const& values);

  /// A number that is no type of the control's (AX2005).
  [[nodiscard]] bool has_unknown_type() const;
  /// also none if the type cannot be used or is out of range.
  [[nodiscard]] FirType configured_type() const;
  /// Type 1 to 4, enabled or not: #FILTER may switch it on.
  [[nodiscard]] bool configured() const { return configured_type() != FirType::none; }
  /// 200, for the time delay 100.
  [[nodiscard]] std::uint32_t longest_order() const;
  /// order or, if that is 0, the order that order_time gives; 0 if neither gives one. May exceed
  /// longest_order().
  [[nodiscard]] double resulting_order(design::CycleTime cycle_time) const;
  /// The kernel of a configured filter with the lists' values, of order 0 if there is no order; none if a
  /// value is out of range. Values that the type ignores keep the specification's own defaults, so that equal
  /// filters have equal specifications.
  [[nodiscard]] std::optional<design::KernelSpecification> specification(design::CycleTime cycle_time) const;
  /// The place of a finding about `wanted`, as in FilterView.
  [[nodiscard]] EffectiveValue const& anchor(EffectiveValue const& wanted) const;
};

}  // namespace axisc::validator
