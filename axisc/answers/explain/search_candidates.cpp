#include "axisc/answers/explain/search_candidates.hpp"

#include "axisc/answers/explain/search_text.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace axisc {

namespace {

std::size_t points_of(std::size_t entries) {
  constexpr std::size_t most = 5;
  auto const fourfolds = static_cast<std::size_t>(std::bit_width(entries) - 1) / 2;
  return most - std::min(most, fourfolds);
}

}  // namespace

Rarity::Rarity(SearchQuery const& query) : words_(query.words), entries_(query.words.size()) {}

void Rarity::count(Coverage const& found) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (found.fits[i]) ++entries_[i];
  }
}

std::size_t Rarity::points(Coverage const& found) const {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (found.fits[i] && !tells_a_fault(words_[i])) sum += points_of(entries_[i]);
  }
  return sum;
}

bool is_good(Hit const& hit) {
  return hit.likeness != Likeness::some_words;
}

std::vector<Hit> fitting_words(std::vector<Candidate> candidates, Rarity const& rarity,
                               SearchQuery const& query) {
  std::size_t most_words = (query.words.size() + 1) / 2;
  std::size_t most_of_good = 0;
  for (auto const& [hit, found] : candidates) {
    auto& most = is_good(hit) ? most_of_good : most_words;
    most = std::max(most, found.words);
  }
  std::vector<Hit> hits;
  hits.reserve(candidates.size());
  for (auto& [hit, found] : candidates) {
    bool const is_kept = is_good(hit) || found.words == most_words;
    if (!is_kept) continue;
    if (!is_good(hit) && most_of_good > 0 && found.words > most_of_good) hit.likeness = Likeness::words;
    hit.points += rarity.points(found);
    hits.push_back(std::move(hit));
  }
  return hits;
}

}  // namespace axisc
