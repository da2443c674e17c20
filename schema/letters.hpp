// The letters of a text: they quickly rule out that two texts are a few slips apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace axisc::schema {

/// The letters that a text has, and those that it has at least twice: one bit each. Letters that share a bit
/// make it less telling, not wrong.
using Letters = std::uint64_t;

/// True if no edit_distance() of texts with these letters is within `limit`: a slip adds or takes away one
/// letter at most.
[[nodiscard]] inline bool certainly_beyond(Letters a, Letters b, std::size_t limit) {
  Letters only_a = a & ~b;
  Letters only_b = b & ~a;
  for (; limit > 0; --limit) {
    only_a &= only_a - 1;
    only_b &= only_b - 1;
  }
  return (only_a | only_b) != 0;
}

/// False if neither of two texts with these letters can contain the other: a part has no letter that the
/// whole lacks.
[[nodiscard]] inline bool may_contain_one_another(Letters a, Letters b) {
  return (a & ~b) == 0 || (b & ~a) == 0;
}

/// The letters that a text has an odd number of times: less telling than Letters, but small enough to be
/// compared many at once.
using OddLetters = std::uint16_t;

struct LetterSets {
  Letters letters = 0;
  OddLetters odd = 0;
};
[[nodiscard]] LetterSets letter_sets_of(std::string_view text);

inline constexpr std::size_t letters_at_once = 16;
/// Which of `known` may belong to a text whose edit_distance() from a given one is within `limit`, one bit
/// each: a slip changes two letters at most.
[[nodiscard]] std::uint32_t may_be_within(std::size_t limit, OddLetters given,
                                          std::span<OddLetters const, letters_at_once> known);

}  // namespace axisc::schema
