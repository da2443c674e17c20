// Which quantities an axis feeds forward.
#pragma once

#include "validator/values/effective_values.hpp"

#include <cstdint>

namespace axisc::validator {

/// A delay of one quantity of so many NC cycles or more is refused, and 0 counts.
inline constexpr double refused_delay_cycles = 6;

/// Bits of P-AXIS-00223. A quantity is weighted, or added to the telegram as it is; then it has both bits.
enum class Feedforward : std::uint32_t {
  velocity = 0x1,
  acceleration = 0x2,
  jerk = 0x4,
  added_velocity = 0x100,
  added_acceleration = 0x200,
  added_jerk = 0x800,
};

/// The reference stays valid while the EffectiveValues live.
struct FeedforwardView {
  EffectiveValue const& quantities;  ///< P-AXIS-00223

  explicit FeedforwardView(EffectiveValues const& values) : quantities(values.at("vorsteuer.vorsteuerung")) {}

  /// P-AXIS-00223 is usable and has the bit.
  [[nodiscard]] bool uses(Feedforward quantity) const {
    auto const bits = static_cast<std::uint32_t>(quantities.value.number);
    return !quantities.unusable && (bits & static_cast<std::uint32_t>(quantity)) != 0;
  }
  /// P-AXIS-00223 is usable and NONE.
  [[nodiscard]] bool is_none() const { return !quantities.unusable && !quantities.value.flag(); }
};

}  // namespace axisc::validator
