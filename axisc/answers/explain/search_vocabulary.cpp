#include "axisc/answers/explain/search_vocabulary.hpp"

#include "axisc/answers/explain/search_text.hpp"
#include "diagnostics/fnv.hpp"
#include "schema/edit_distance.hpp"
#include "schema/lookup/lookup.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace axisc {

namespace {

constexpr std::size_t shortest_word_part = 4;
constexpr std::size_t most_joined = 3;

Sense own_sense(std::string_view folded_word) {
  return sense_as_spelled(stem(folded_word));
}

std::unordered_set<Sense> hashes_of(schema::WordGroup words) {
  std::unordered_set<Sense> set;
  for (auto const word : words) set.insert(sense_as_spelled(folded(word)));
  return set;
}

/// "500hz" is a figure like "500".
bool is_figure(std::string_view word, std::unordered_set<Sense> const& units) {
  auto const rest = word.substr(std::min(word.find_first_not_of("0123456789"), word.size()));
  return rest.size() < word.size() && (rest.empty() || units.contains(sense_as_spelled(rest)));
}

/// How much a word says, the least first.
enum class Weight : std::uint8_t { none, filler, figure, weak, telling };

struct Weighed {
  TellingWord word;
  Weight weight = Weight::none;
};

}  // namespace

Sense sense_as_spelled(std::string_view folded_word) {
  return fnv1a(folded_word);
}

void add_once(std::vector<Sense>& senses, Sense sense) {
  if (std::find(senses.begin(), senses.end(), sense) == senses.end()) senses.push_back(sense);
}

Vocabulary::Vocabulary()
    : fillers_(hashes_of(schema::search_words().fillers)),
      units_(hashes_of(schema::search_words().units)),
      prepositions_(hashes_of(schema::search_words().prepositions)),
      for_messages_(hashes_of(schema::search_words().for_messages)) {
  std::vector<std::pair<Sense, Sense>> stems;
  auto const add = [&](std::span<schema::WordGroup const> groups, std::unordered_set<Sense>* kind) {
    for (auto const& group : groups) {
      auto const sense = sense_as_spelled(folded(group.front()));
      for (auto const word : group) {
        words_.push_back(folded(word));
        auto const parts = words_of(word);
        if (parts.size() > 1) beginnings_.insert(sense_as_spelled(parts.front()));
        groups_.emplace(sense_as_spelled(words_.back()), sense);
        stems.emplace_back(own_sense(words_.back()), sense);
      }
      if (kind != nullptr) kind->insert(sense);
    }
  };
  auto const& words = schema::search_words();
  add(words.faults, &faults_);
  add(words.degrees, &degrees_);
  add(words.actions, &actions_);
  add(words.same, nullptr);
  // A word as it is comes before what its stem has in common with others: "highest" is not "high".
  for (auto const& [stem, sense] : stems) groups_.emplace(stem, sense);
  for (auto const filler : words.fillers) filling_stems_.insert(own_sense(folded(filler)));
}

Sense const* Vocabulary::group_of(std::string_view folded_word) const {
  auto found = groups_.find(sense_as_spelled(folded_word));
  if (found == groups_.end()) found = groups_.find(own_sense(folded_word));
  return found == groups_.end() ? nullptr : &found->second;
}

Sense Vocabulary::sense_of(std::string_view folded_word) const {
  auto const* const group = group_of(folded_word);
  return group == nullptr ? own_sense(folded_word) : *group;
}

/// All parts must be known; the longest first part wins: "Grenz|frequenz" is a word of its own elsewhere.
bool Vocabulary::add_parts(std::vector<Sense>& senses, std::string_view composed) const {
  for (std::size_t size = composed.size(); size >= shortest_word_part; --size) {
    auto const rest = composed.substr(size);
    if (!rest.empty() && rest.size() < shortest_word_part) continue;
    auto const part = composed.substr(0, size);
    auto const* const group = group_of(part);
    if (group == nullptr && !filling_stems_.contains(own_sense(part))) continue;
    auto const before = senses.size();
    if (group != nullptr) senses.push_back(*group);
    if (rest.empty() || add_parts(senses, rest)) return true;
    senses.resize(before);
  }
  return false;
}

std::vector<Sense> Vocabulary::senses_of(std::string_view folded_word) const {
  if (auto const* const group = group_of(folded_word)) return {*group};
  std::vector<Sense> senses;
  bool const is_composed =
      folded_word.size() >= 2 * shortest_word_part && add_parts(senses, folded_word) && !senses.empty();
  return is_composed ? senses : std::vector{own_sense(folded_word)};
}

TellingWords Vocabulary::telling_words(std::string_view text) const {
  auto const words = words_of(text);
  TellingWords telling;
  std::vector<Weighed> all;
  auto most = Weight::none;
  bool is_beside = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    auto joined = words[i];
    std::size_t joins = 0;
    auto longer = joined;
    bool const begins = beginnings_.contains(sense_as_spelled(joined));
    for (std::size_t k = 1; begins && k < most_joined && i + k < words.size(); ++k) {
      longer += words[i + k];
      if (!is_known(longer)) continue;
      joined = longer;
      joins = k;
    }
    // "switch it on": what stands in front is a filler, at the end a word.
    bool const is_last = i > 0 && i + 1 == words.size() && is_known(joined);
    bool const is_unit = i > 0 && is_number(words[i - 1]) && units_.contains(sense_as_spelled(joined));
    bool const may_fill = joins == 0 && !is_last;
    is_beside = is_beside || (most == Weight::telling && prepositions_.contains(sense_as_spelled(words[i])));
    telling.ask_for_message = telling.ask_for_message || for_messages_.contains(sense_as_spelled(joined));
    for (auto const sense : senses_of(joined)) {
      auto weight = is_of_faults(sense) || is_action(sense) ? Weight::weak : Weight::telling;
      if (may_fill && is_figure(joined, units_)) weight = Weight::figure;
      if (may_fill && (is_filler(joined) || is_unit)) weight = Weight::filler;
      most = std::max(most, weight);
      all.push_back({.word = {.folded = joined, .sense = sense, .is_beside = is_beside}, .weight = weight});
    }
    i += joins;
  }
  // Beside nothing but a fault or an action fillers tell what is meant: "unknown axis", "value missing".
  auto const least = most == Weight::telling ? Weight::weak : most == Weight::figure ? most : Weight::none;
  for (auto& [word, weight] : all) {
    if (weight >= least) telling.words.push_back(std::move(word));
  }
  return telling;
}

std::string Vocabulary::nearest(std::string_view folded_word) const {
  auto best = accepted_slips(folded_word.size()) + 1;
  std::string found;
  for (auto const& word : words_) {
    auto const accepted = std::min(best - 1, accepted_slips(word.size()));
    if (accepted == 0) continue;
    auto const distance = schema::edit_distance(folded_word, word, accepted);
    if (distance > accepted) continue;
    best = distance;
    found = word;
  }
  return found;
}

bool Vocabulary::is_filler(std::string_view folded_word) const {
  return fillers_.contains(sense_as_spelled(folded_word));
}

Vocabulary const& vocabulary() {
  static Vocabulary const words;
  return words;
}

}  // namespace axisc
