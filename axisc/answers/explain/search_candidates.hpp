// Which of the entries that have words of a query are kept, and in which order.
#pragma once

#include "axisc/answers/explain/search_words.hpp"

#include <cstddef>
#include <vector>

namespace axisc {

struct Candidate {
  SearchEntry const* entry = nullptr;
  Coverage found;
};

[[nodiscard]] bool is_good(Hit const& hit);

/// `words_of_all` says of each word of the query how many entries have it. Of those that have but some of the
/// words the ones that have most, at least half, and those that are worth more than any with all words or a
/// phrase.
[[nodiscard]] std::vector<Hit> fitting_words(std::vector<Candidate> const& candidates,
                                             std::vector<std::size_t> const& words_of_all,
                                             SearchQuery const& query);

}  // namespace axisc
