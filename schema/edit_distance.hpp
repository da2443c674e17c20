// How far a mistyped word is from a known one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace axisc::schema {

/// Longer words are equal or too far apart.
inline constexpr std::size_t longest_compared = 128;

/// Optimal string alignment distance: insertions, deletions, replacements and swaps of neighbours, none of
/// them twice at one place. Distances above `limit` are all reported as limit + 1. Cost: the length of the
/// longer word, without the common beginning and end; times limit where more than 64 letters of the shorter
/// one are left.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// How many mistakes still look like a slip of the pen in a word of this length: a third of it, from 1 to 4.
[[nodiscard]] constexpr std::size_t tolerable_distance(std::size_t length) {
  return std::clamp<std::size_t>(length / 3, 1, 4);
}

}  // namespace axisc::schema
