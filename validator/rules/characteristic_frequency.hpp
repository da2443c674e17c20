// Every characteristic frequency that something of an axis is designed with.
#pragma once

#include "validator/engine/rule.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace axisc::validator::checks {

/// The part of the control that designs a filter, and that speaks of it.
enum class Filtering : std::uint8_t { setpoint, position_controller };

/// References stay valid while the EffectiveValues live.
struct CharacteristicFrequency {
  EffectiveValue const& frequency;
  EffectiveValue const& anchor;  ///< where a finding about it stands
  std::string user;              ///< what uses it, as a list writes it: "LOWPASS", "filter_fir.type 3"
  Filtering filtering;
};

/// Of the active standard filters, a configured HSC NoVib or windowed sinc, and the active stages of the
/// Improved Position Control, where a list or a meaningful default gives one.
[[nodiscard]] std::vector<CharacteristicFrequency> characteristic_frequencies(AxisContext const& axis);

}  // namespace axisc::validator::checks
