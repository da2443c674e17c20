// In what a force was recorded, and what follows for mass and friction.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace axisc {

enum class ForceKind : std::uint8_t {
  newton,
  newton_metre,
  other,  ///< A, %, or not known
};

struct ForceUnit {
  ForceKind kind = ForceKind::other;
  double factor = 1;   ///< of the recorded numbers, into N or Nm
  std::string symbol;  ///< "N", "Nm", else as recorded: "A"; empty where nothing names it

  bool operator==(ForceUnit const&) const = default;
};

/// "N", "kN", "Nm", "mNm" and the like; every other one is what the drive shows.
[[nodiscard]] ForceUnit force_unit_of(std::string_view named);

/// What is identified has these units, of an axis whose position is in m or rad.
struct ModelUnits {
  std::string force;    ///< "N"
  std::string mass;     ///< "kg", "kg m²", "A/(m/s²)"
  std::string viscous;  ///< "N/(m/s)"
};
/// `unknown` stands for a force without a unit.
[[nodiscard]] ModelUnits model_units(ForceUnit const& force, bool is_rotary, std::string_view unknown);

}  // namespace axisc
