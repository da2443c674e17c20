// What drives an axis, and where its position is controlled: the machine file says it before the lists.
#pragma once

#include "validator/loading/loading.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace axisc::validator {

struct DriveType {
  std::string_view word;  ///< as machine files write it
  std::uint32_t number;   ///< of P-AXIS-00020
  /// Improved Position Control exists for it, and it controls the position itself unless told otherwise.
  bool digital;
};

inline constexpr std::array<DriveType, 10> drive_types = {{
    {.word = "SERCOS", .number = 2, .digital = true},
    {.word = "PROFIDRIVE", .number = 3, .digital = true},
    {.word = "CANopen", .number = 8, .digital = true},
    {.word = "simulation", .number = 4, .digital = false},
    {.word = "conventional", .number = 1, .digital = false},
    {.word = "Lightbus", .number = 5, .digital = false},
    {.word = "terminal", .number = 6, .digital = false},
    {.word = "RT Ethernet", .number = 7, .digital = false},
    {.word = "virtual", .number = 16, .digital = false},
    {.word = "CAN", .number = 32, .digital = false},
}};

/// The machine file's drive, else that of P-AXIS-00020, set or not; null for a number that is not documented.
[[nodiscard]] DriveType const* drive_of(LoadedAxis const& axis);

/// Machine file, else P-AXIS-00320, else by drive type; unknown for an open position loop, and where the lists' values
/// cannot be used.
[[nodiscard]] machine::PositionController position_controller(LoadedAxis const& axis);

/// P-AXIS-00320 is one of OPEN_POSITION_LOOP_…
[[nodiscard]] bool is_open_loop(EffectiveValue const& operation_mode);

}  // namespace axisc::validator
