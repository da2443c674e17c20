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

struct Candidate {
  std::size_t name = 0;  ///< its number in the vocabulary
  std::size_t cost = 0;
  std::size_t text_distance = 0;  ///< between the names as a whole
};

/// Candidates that are more than this worse than the best are left out.
inline constexpr std::size_t tolerance_to_best = 1;
/// Up to this many slips in a name as a whole count as such, wherever they are: a dot may replace an
/// underscore.
inline constexpr std::size_t few_slips = 2;

/// Those that are not much worse than the best, in no order. `bare` is `name` without indices. Where a name
/// with one slip at most is known, only names that are nearly as close are compared; else every name that has
/// a part or a size in common with it.
[[nodiscard]] std::vector<Candidate> candidates_for(Vocabulary const& vocabulary, IndexedName const& name,
                                                    std::string_view bare);
/// The same the long way, whatever is known.
[[nodiscard]] std::vector<Candidate> distant_candidates(Vocabulary const& vocabulary, IndexedName const& name,
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

}  // namespace axisc::schema
