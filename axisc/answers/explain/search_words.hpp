// How many words of a query an entry has, and what that is worth.
#pragma once

#include "axisc/answers/explain/search.hpp"
#include "axisc/answers/explain/search_entries.hpp"
#include "axisc/answers/explain/search_query.hpp"

#include <cstddef>
#include <vector>

namespace axisc {

struct Coverage {
  std::size_t words = 0;
  std::vector<bool> fits;  ///< for each word of the query
  std::size_t points = 0;
  bool is_spelled_so = true;  ///< every word that fits is a word there, letter by letter
  bool is_named = false;      ///< one of them is a word of its name, or people's word for it
};

[[nodiscard]] Coverage coverage(SearchEntry const& entry, SearchQuery const& query);

/// A phrase makes up for a word that does not fit.
[[nodiscard]] Hit hit_of_words(SearchEntry const& entry, SearchQuery const& query, Coverage const& found);

}  // namespace axisc
