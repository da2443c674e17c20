// The known names that a mistyped one may have meant.
#pragma once

#include "schema/indexed_name.hpp"
#include "schema/vocabulary.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace axisc::schema {

/// The typing mistake, the likeliest first: the costs of a candidate.
enum class Slip : std::uint8_t {
  former_name = 0,   ///< the vendor once used this name
  one_letter = 1,    ///< one slip of the pen, in one part or between two
  whole_part = 1,    ///< a part is missing, abbreviated, or two words or parts are swapped
  two_letters = 2,   ///< in one part of at least eight letters
  resemblance = 3,   ///< a part is some words of another: `share` for `share_percent`
  more_letters = 4,  ///< in the last part
};

struct Candidate {
  std::size_t name = 0;  ///< its number in the vocabulary
  Slip slip{};
  bool begins_alike = true;       ///< the first part is not missing
  std::size_t text_distance = 0;  ///< between the names as a whole
};

/// Names that differ from `name` by one slip, in no order; none that are much less likely than the best. The
/// last two slips are looked for in the family of `name` alone. `bare` is `name` without indices.
[[nodiscard]] std::vector<Candidate> candidates_for(Vocabulary const& vocabulary, IndexedName const& name,
                                                    std::string_view bare);

/// Calls `visit(name)` for the names that may be within `limit` slips of `bare`, by their size and letters.
template <typename Visit>
void for_each_of_like_letters(Vocabulary const& vocabulary, std::string_view bare, std::size_t limit,
                              Visit visit) {
  LetterSets const sets = letter_sets_of(bare);
  Groups const& by_size = vocabulary.names_of_size;
  std::size_t const shortest = std::min(bare.size() - std::min(bare.size(), limit), by_size.size());
  std::size_t const longest_end = std::max(shortest, std::min(bare.size() + limit + 1, by_size.size()));
  std::size_t const end = by_size.starts[longest_end];
  for (std::size_t first = by_size.starts[shortest]; first < end; first += letters_at_once) {
    std::span<OddLetters const, letters_at_once> const known(
        vocabulary.odd_letters_by_size.subspan(first, letters_at_once));
    std::uint32_t possible = may_be_within(limit, sets.odd, known);
    if (end - first < letters_at_once) possible &= (1U << (end - first)) - 1U;
    for (; possible != 0; possible &= possible - 1) {
      std::size_t const at = first + static_cast<std::size_t>(std::countr_zero(possible));
      if (!certainly_beyond(sets.letters, vocabulary.letters_by_size[at], limit)) visit(by_size.numbers[at]);
    }
  }
}

/// True if the shorter word is one or several whole words of the longer: `share` in `share_percent`.
[[nodiscard]] bool resembles(std::string_view a, std::string_view b);

/// How many slips of the pen are one mistake in a part of this length.
[[nodiscard]] constexpr std::size_t slips_of_the_pen(std::size_t length) {
  return length < 8 ? 1 : 2;
}

}  // namespace axisc::schema
