// How many words of a query an entry has, and what that is worth.
#pragma once

#include "axisc/answers/explain/search.hpp"
#include "axisc/answers/explain/search_entries.hpp"
#include "axisc/answers/explain/search_query.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace axisc {

/// How a word of the query is like a word of an entry, the least first.
enum class Fit : std::uint8_t { none, composed, mistyped, part, beginning, whole };

/// How the words of a query are like all words that entries have.
class Fits {
 public:
  Fits(SearchQuery const& query, std::vector<EntryWord> const& words);

  /// The best in a list, of a word of the query.
  [[nodiscard]] Fit best(std::size_t word, WordPlaces const& places, bool is_about_fault) const;

 private:
  struct OfWord {
    std::vector<Fit> spelled;  ///< letter by letter alone
    std::vector<Fit> meant;    ///< in other words, too
    bool is_of_faults = false;
  };
  std::vector<OfWord> fits_;
};

struct Coverage {
  std::size_t words = 0;
  std::vector<std::uint8_t> points;  ///< for each word of the query; 0: it is not there
  bool is_spelled_so = true;         ///< every word that is there is a word of the entry, no piece of one
  bool is_named = false;             ///< one of them is a word of its name, or people's word for it
};

[[nodiscard]] Coverage coverage(SearchEntry const& entry, SearchQuery const& query, Fits const& fits);

/// Words of the query that are the name of the entry, its title, or people's words for it, in any order.
struct FoundPhrase {
  std::size_t words = 0;
  std::size_t missing = 0;        ///< that the phrase has beside them
  std::size_t other_actions = 0;  ///< that it has beside them, "off" instead of "on": no words are missing
  std::vector<bool> has;          ///< for each word of the query
};

/// The longest phrase without missing words, or else the one of which most words are there.
[[nodiscard]] FoundPhrase found_phrase(SearchEntry const& entry, SearchQuery const& query);

}  // namespace axisc
