#include "axisc/answers/explain/search_words.hpp"

#include "axisc/answers/explain/search_text.hpp"
#include "schema/edit_distance.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

namespace axisc {

namespace {

bool is_slip_of(std::string const& word, std::string const& known) {
  auto const accepted = accepted_slips(word.size());
  auto const [shorter, longer] = std::minmax({word.size(), known.size()});
  // Another number is another message: it has no typing errors.
  return accepted > 0 && longer - shorter <= accepted && accepted_slips(known.size()) > 0 &&
         !is_number(known) && schema::edit_distance(word, known, accepted) <= accepted;
}

/// German composes: "frequenz" is in "mittenfrequenz", and "Achsgeschwindigkeit" ends in "geschwindigkeit",
/// while "mitte" in the midst of "Kühlmittel" is no word.
Fit spelled_fit(std::string const& word, std::string const& other) {
  constexpr std::size_t shortest_beginning = 3;
  constexpr std::size_t shortest_part = 4;
  if (other == word) return Fit::whole;
  if (is_number(word)) return Fit::none;
  if (word.size() >= shortest_beginning && other.starts_with(word)) return Fit::beginning;
  if (word.size() >= shortest_part && other.find(word) != std::string::npos) return Fit::part;
  if (is_slip_of(word, other)) return Fit::mistyped;
  bool const is_composed = other.size() > shortest_part && (word.starts_with(other) || word.ends_with(other));
  return is_composed ? Fit::composed : Fit::none;
}

Fit meant_fit(Sense sense, EntryWord const& other) {
  bool const is_there = std::find(other.senses.begin(), other.senses.end(), sense) != other.senses.end();
  if (!is_there) return Fit::none;
  return other.senses.size() == 1 ? Fit::whole : Fit::beginning;
}

std::uint8_t points_in_a_name(Fit fit) {
  switch (fit) {
    case Fit::whole: return 6;
    case Fit::beginning: return 5;
    case Fit::part:
    case Fit::mistyped: return 4;
    case Fit::composed: return 1;
    case Fit::none: break;
  }
  return 0;
}

std::uint8_t points_in_a_meaning(Fit fit) {
  switch (fit) {
    case Fit::whole: return 3;
    case Fit::beginning: return 2;
    case Fit::part:
    case Fit::composed:
    case Fit::mistyped: return 1;
    case Fit::none: break;
  }
  return 0;
}

}  // namespace

Fits::Fits(SearchQuery const& query, std::vector<EntryWord> const& words) : fits_(query.words.size()) {
  for (std::size_t i = 0; i < query.words.size(); ++i) {
    auto const& word = query.words[i];
    auto& fits = fits_[i];
    fits.is_of_faults = vocabulary().is_of_faults(word.sense);
    fits.spelled.reserve(words.size());
    fits.meant.reserve(words.size());
    bool const is_known = vocabulary().is_known(word.folded);
    for (auto const& other : words) {
      auto const meant = meant_fit(word.sense, other);
      // "stop" has nothing to do with "bandstop", although it is a part of it.
      bool const is_another = is_known && other.is_known && meant == Fit::none;
      fits.spelled.push_back(is_another ? Fit::none : spelled_fit(word.folded, other.folded));
      fits.meant.push_back(std::max(fits.spelled.back(), meant));
    }
  }
}

Fit Fits::best(std::size_t word, WordPlaces const& places, bool is_about_fault) const {
  auto const& of_word = fits_[word];
  auto const& fits = of_word.is_of_faults && !is_about_fault ? of_word.spelled : of_word.meant;
  auto best = Fit::none;
  for (auto const place : places) best = std::max(best, fits[place]);
  return best;
}

Coverage coverage(SearchEntry const& entry, SearchQuery const& query, Fits const& fits) {
  Coverage found;
  found.points.reserve(query.words.size());
  for (std::size_t i = 0; i < query.words.size(); ++i) {
    auto const named = fits.best(i, entry.name_words, entry.is_about_fault);
    auto const meant = fits.best(i, entry.meaning_words, entry.is_about_fault);
    found.points.push_back(std::max(points_in_a_name(named), points_in_a_meaning(meant)));
    if (found.points.back() > 0) ++found.words;
    if (named == Fit::whole) found.is_named = true;
    if (named != Fit::whole && meant != Fit::whole) found.is_spelled_so = false;
  }
  return found;
}

FoundPhrase found_phrase(SearchEntry const& entry, SearchQuery const& query) {
  FoundPhrase best;
  best.missing = 1;
  for (auto const& phrase : entry.phrases) {
    if (phrase.asks_for_message && !query.asks_for_message) continue;
    FoundPhrase found;
    found.has.resize(query.words.size());
    std::size_t telling = 0;
    for (auto const sense : phrase.senses) {
      auto const word = std::find(query.senses.begin(), query.senses.end(), sense) - query.senses.begin();
      bool const is_there = static_cast<std::size_t>(word) < query.senses.size();
      bool const is_action = vocabulary().is_action(sense);
      if (is_there) found.has[static_cast<std::size_t>(word)] = true;
      if (is_there) ++found.words;
      if (is_there && !is_action) ++telling;
      if (!is_there) ++(is_action ? found.other_actions : found.missing);
    }
    if (telling == 0 && found.words < query.words.size()) continue;
    auto const rank = [](FoundPhrase const& one) {
      return std::tuple(one.missing == 0, one.words, -static_cast<int>(one.other_actions));
    };
    if (found.words > 0 && rank(found) > rank(best)) best = std::move(found);
  }
  return best;
}

}  // namespace axisc
