// Every way in which a control may plan a path where its manuals leave it open: each reading of each key of
// `motion` in axisc.json with each of all others.
#pragma once

#include "configuration/machine/path_dynamics.hpp"

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace axisc::comparison {

/// In the order of machine::for_each_reading.
enum class MotionKey : std::uint8_t { projection, borders, sine, circle, corner, weights, cycles, hsc };
inline constexpr std::size_t motion_key_count = 8;

[[nodiscard]] constexpr std::size_t index_of(MotionKey key) {
  return static_cast<std::size_t>(key);
}

struct MotionKeyWords {
  std::string_view key;
  std::span<std::string_view const> words;
};
[[nodiscard]] std::array<MotionKeyWords, motion_key_count> motion_key_words();

/// The number of the word that each key has.
using Combination = std::array<std::uint8_t, motion_key_count>;
using MotionKeys = std::bitset<motion_key_count>;

[[nodiscard]] Combination combination_of(machine::MotionReadings const& readings);
[[nodiscard]] machine::MotionReadings readings_of(Combination const& combination);

/// 576 of them, the defaults first.
[[nodiscard]] std::vector<Combination> all_combinations();

/// Other keys have their defaults.
[[nodiscard]] Combination only(Combination combination, MotionKeys const& keys);

}  // namespace axisc::comparison
