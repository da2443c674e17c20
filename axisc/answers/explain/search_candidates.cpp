#include "axisc/answers/explain/search_candidates.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace axisc {

namespace {

/// A word that few entries have says more than one that many have: seven for a single entry, one less for
/// each fourfold. That something is wrong says little about the subject.
std::vector<std::size_t> weights_of(SearchQuery const& query, std::vector<std::size_t> const& entries) {
  constexpr std::size_t most = 7;
  constexpr std::size_t least = 1;
  std::vector<std::size_t> weights;
  weights.reserve(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto const fourfolds = static_cast<std::size_t>(std::bit_width(entries[i])) / 2;
    auto const weight = std::max(least, most - std::min(most, fourfolds));
    auto const& word = query.words[i];
    bool const is_weak = vocabulary().is_of_faults(word.sense) || vocabulary().is_action(word.sense);
    weights.push_back(is_weak ? least : word.is_beside ? (weight + 1) / 2 : weight);
  }
  return weights;
}

/// A query that names a fault means a message or a rule rather than the parameter behind it; one that asks
/// for a message means a message.
std::size_t preference(SearchEntry const& entry, SearchQuery const& query) {
  constexpr std::size_t of_a_message = 32;
  constexpr std::size_t of_a_fault = 32;
  bool const is_message = std::holds_alternative<schema::ControlMessage const*>(entry.subject);
  if (query.asks_for_message && is_message) return of_a_message;
  return query.tells_fault && entry.is_about_fault ? of_a_fault : 0;
}

/// All that is no fault and no action.
bool has_subject(SearchQuery const& query, Coverage const& found) {
  for (std::size_t i = 0; i < query.words.size(); ++i) {
    auto const sense = query.words[i].sense;
    bool const is_weak = vocabulary().is_of_faults(sense) || vocabulary().is_action(sense);
    if (!is_weak && found.points[i] == 0) return false;
  }
  return true;
}

/// A phrase makes up for words that are missing.
Hit hit_of(Candidate const& candidate, std::vector<std::size_t> const& weights, SearchQuery const& query) {
  constexpr std::size_t bonus = 12;
  constexpr std::size_t bonus_of_some = 3;
  constexpr std::size_t all_words = 20;
  constexpr std::size_t missing_word = 10;
  constexpr std::size_t missing_weak_word = 6;
  constexpr std::size_t of_its_weight = 2;
  constexpr std::size_t other_action = 20;
  auto const& found = candidate.found;
  auto const phrase = found_phrase(*candidate.entry, query);
  bool const has_phrase = phrase.missing == 0 && !query.is_path;
  auto const missing = query.words.size() - found.words;
  auto points = has_subject(query, found) || has_phrase ? preference(*candidate.entry, query) : 0;
  if (has_subject(query, found)) points += all_words;
  auto lost = has_phrase ? phrase.other_actions * other_action : 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    // A fault or an action that is missing is no great loss.
    bool const is_weak = weights[i] == 1;
    if (found.points[i] == 0) lost += is_weak ? missing_weak_word : missing_word + of_its_weight * weights[i];
    points += weights[i] * found.points[i];
    bool const is_in_phrase = phrase.words > 0 && phrase.has[i];
    if (is_in_phrase && has_phrase) points += weights[i] * bonus;
    if (is_in_phrase && !has_phrase && phrase.words > 1) points += weights[i] * bonus_of_some;
  }
  bool const is_more_than_pieces = *std::max_element(found.points.begin(), found.points.end()) > 1;
  return {.subject = candidate.entry->subject,
          .likeness =
              (missing == 0 && is_more_than_pieces) || has_phrase ? Likeness::words : Likeness::some_words,
          .points = points > lost ? points - lost : 0,
          .read_as = {},
          .is_named = has_phrase || (missing == 0 && found.is_named)};
}

}  // namespace

bool is_good(Hit const& hit) {
  return hit.likeness != Likeness::some_words;
}

std::vector<Hit> fitting_words(std::vector<Candidate> const& candidates,
                               std::vector<std::size_t> const& words_of_all, SearchQuery const& query) {
  auto const weights = weights_of(query, words_of_all);
  std::size_t most_words = (query.words.size() + 1) / 2;
  std::size_t best_of_good = 0;
  std::vector<Hit> all;
  all.reserve(candidates.size());
  for (auto const& candidate : candidates) {
    all.push_back(hit_of(candidate, weights, query));
    if (is_good(all.back())) {
      best_of_good = std::max(best_of_good, all.back().points);
    } else {
      most_words = std::max(most_words, candidate.found.words);
    }
  }
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto& hit = all[i];
    bool const has_enough = candidates[i].found.words * 2 >= query.words.size();
    if (!is_good(hit) && has_enough && best_of_good > 0 && hit.points > best_of_good) {
      hit.likeness = Likeness::words;
    }
    if (is_good(hit) || candidates[i].found.words == most_words) hits.push_back(std::move(hit));
  }
  return hits;
}

}  // namespace axisc
