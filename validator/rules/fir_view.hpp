// The parameters of an axis' FIR filter, seen together: filter_fir.
#pragma once

#include "validator/effective_values.hpp"

#include <cstdint>

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
  EffectiveValue const& share;
  EffectiveValue const& frequency;
  EffectiveValue const& quality;

  explicit FirView(EffectiveValues const& values);

  /// none as well where the type cannot be used or is out of range.
  [[nodiscard]] FirType configured_type() const;
  /// Type 1 to 4, enabled or not: #FILTER may switch it on.
  [[nodiscard]] bool configured() const { return configured_type() != FirType::none; }
  /// Where a finding about `wanted` stands, as for FilterView.
  [[nodiscard]] EffectiveValue const& anchor(EffectiveValue const& wanted) const;
};

}  // namespace axisc::validator
