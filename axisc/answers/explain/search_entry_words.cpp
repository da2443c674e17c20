#include "axisc/answers/explain/search_entry_words.hpp"

#include "axisc/answers/explain/search_text.hpp"

#include <utility>

namespace axisc {

EntryWords::EntryWords() {
  constexpr std::size_t expected = 16384;
  places_.reserve(expected);
  words_.reserve(expected);
}

void EntryWords::add_meaning(WordPlaces& places, std::string_view text) {
  // Shorter ones are prepositions and the like.
  constexpr std::size_t shortest = 3;
  for (auto const written : written_words(text)) {
    if (written.size() >= shortest) places.push_back(place_of(written));
  }
}

void EntryWords::add_name(WordPlaces& places, std::string_view text) {
  for (auto const written : written_words(text)) add_word_of_name(places, written);
}

void EntryWords::add_word_of_name(WordPlaces& places, std::string_view word) {
  auto const place = place_of(word);
  is_of_a_name_[place] = true;
  places.push_back(place);
}

std::uint32_t EntryWords::place_of(std::string_view written) {
  auto const found = places_.find(written);
  if (found != places_.end()) return found->second;
  auto word = folded(written);
  auto const [other, is_new] = places_.try_emplace(word, static_cast<std::uint32_t>(words_.size()));
  auto const place = other->second;
  if (is_new) {
    words_.push_back({.folded = word});
    is_of_a_name_.push_back(false);
  }
  if (written != word) places_.try_emplace(std::string(written), place);
  return place;
}

std::vector<EntryWord> EntryWords::take() && {
  for (std::size_t i = 0; i < words_.size(); ++i) {
    auto& word = words_[i];
    // Composed words of descriptions are many, and found by their parts as they are spelled.
    if (is_of_a_name_[i]) {
      word.senses = vocabulary().senses_of(word.folded);
    } else {
      word.senses = {vocabulary().sense_of(word.folded)};
    }
    word.is_known = vocabulary().is_known(word.folded);
  }
  return std::move(words_);
}

}  // namespace axisc
