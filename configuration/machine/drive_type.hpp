// The drives that an axis may have.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace axisc::machine {

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

/// Numbers that rules ask for.
inline constexpr std::uint32_t profidrive = 3;
inline constexpr std::uint32_t lightbus = 5;

}  // namespace axisc::machine
