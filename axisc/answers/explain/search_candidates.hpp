// Which of the entries that have words of a query are kept, and how rare these words are.
#pragma once

#include "axisc/answers/explain/search_words.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace axisc {

/// A word that few entries have says more than one that many have: five points for a single entry, one less
/// for each fourfold. That something is wrong says nothing about the subject.
class Rarity {
 public:
  explicit Rarity(SearchQuery const& query);

  void count(Coverage const& found);
  [[nodiscard]] std::size_t points(Coverage const& found) const;

 private:
  std::vector<std::string> const& words_;
  std::vector<std::size_t> entries_;  ///< that have it, for each word
};

struct Candidate {
  Hit hit;
  Coverage found;
};

[[nodiscard]] bool is_good(Hit const& hit);

/// Of those that have but some words the ones that have most, at least half. Where nothing has more than a
/// phrase of the query, entries with more of its words are as good.
[[nodiscard]] std::vector<Hit> fitting_words(std::vector<Candidate> candidates, Rarity const& rarity,
                                             SearchQuery const& query);

}  // namespace axisc
