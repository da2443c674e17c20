// The characteristic frequencies of the filters of an axis.
#pragma once

#include "validator/engine/rule.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace axisc::validator::checks {

/// The part of the control that designs a filter and reports about it.
enum class Filtering : std::uint8_t { setpoint, vibration_guard, position_controller, distance_control };

/// References stay valid while the EffectiveValues live.
struct CharacteristicFrequency {
  EffectiveValue const& frequency;
  EffectiveValue const& anchor;  ///< the place of a finding about it
  std::string user;              ///< what uses it, as a list writes it: "LOWPASS", "filter_fir.type 3"
  Filtering filtering;
};

/// The frequencies of the active standard filters, of a configured HSC NoVib or windowed sinc, of the
/// Vibration Guard, which a program may switch on, of the active stages of Improved Position Control, if
/// a list or a meaningful default sets one, and of the low-pass of the distance control that is in use.
[[nodiscard]] std::vector<CharacteristicFrequency> characteristic_frequencies(AxisContext const& axis);

}  // namespace axisc::validator::checks
