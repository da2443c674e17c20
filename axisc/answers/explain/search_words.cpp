#include "axisc/answers/explain/search_words.hpp"

#include "axisc/answers/explain/search_text.hpp"
#include "schema/edit_distance.hpp"

#include <algorithm>
#include <string>
#include <variant>

namespace axisc {

namespace {

bool is_slip_of(std::string const& word, std::string const& known) {
  auto const accepted = accepted_slips(word.size());
  auto const [shorter, longer] = std::minmax({word.size(), known.size()});
  // Another number is another message: it has no typing errors.
  return accepted > 0 && longer - shorter <= accepted && accepted_slips(known.size()) > 0 &&
         !is_number(known) && schema::edit_distance(word, known, accepted) <= accepted;
}

/// What a word of the query is worth that is, begins or is within another word, contains one, or is mistyped.
struct Worth {
  std::size_t whole = 0;
  std::size_t beginning = 0;
  std::size_t part = 0;
  std::size_t mistyped = 0;
  std::size_t compound = 0;
};

constexpr Worth in_a_name{.whole = 10, .beginning = 8, .part = 6, .mistyped = 5, .compound = 2};
constexpr Worth in_a_meaning{.whole = 4, .beginning = 3, .part = 2, .mistyped = 1, .compound = 2};

/// How well one of `known` fits a word of the query; German composes: "frequenz" is in "mittenfrequenz", and
/// "Achsgeschwindigkeit" ends in "geschwindigkeit", while "mitte" in the midst of "Kühlmittel" is no word.
std::size_t fit(std::string const& word, std::vector<std::string> const& known, Worth const& worth) {
  constexpr std::size_t shortest_beginning = 3;
  constexpr std::size_t shortest_part = 4;
  std::size_t best = 0;
  bool const is_of_digits = is_number(word);
  for (auto const& other : known) {
    if (other == word) return worth.whole;
    if (is_of_digits) continue;
    bool const begins = word.size() >= shortest_beginning && other.starts_with(word);
    bool const contains = word.size() >= shortest_part && other.find(word) != std::string::npos;
    bool const is_compound =
        other.size() > shortest_part && (word.starts_with(other) || word.ends_with(other));
    if (begins) best = std::max(best, worth.beginning);
    if (contains) best = std::max(best, worth.part);
    if (is_compound) best = std::max(best, worth.compound);
    if (best < worth.mistyped && is_slip_of(word, other)) best = worth.mistyped;
  }
  return best;
}

/// In names before meanings, unless the meaning has the very word and the name but a piece of it.
std::size_t fit(std::string const& word, SearchEntry const& entry) {
  auto const named = fit(word, entry.name_words, in_a_name);
  if (named >= in_a_meaning.whole) return named;
  return std::max(named, fit(word, entry.meaning_words, in_a_meaning));
}

/// A common word stands for the whole word alone: "klein" has nothing to do with "lowpass".
std::size_t fit_of_common(std::string const& word, SearchEntry const& entry) {
  auto const is_in = [&](std::vector<std::string> const& known) {
    return std::find(known.begin(), known.end(), word) != known.end();
  };
  if (is_in(entry.name_words)) return in_a_name.whole;
  return is_in(entry.meaning_words) ? in_a_meaning.whole : 0;
}

/// Several words of the query, one after the other, are its name or people's words for it.
bool contains_phrase(SearchEntry const& entry, SearchQuery const& query) {
  constexpr std::size_t shortest = 3;
  for (std::size_t first = 0; first < query.words.size(); ++first) {
    std::string part;
    std::string common;
    for (std::size_t i = first; i < query.words.size(); ++i) {
      part += query.words[i];
      common += query.common_words[i];
      if (part.size() < shortest) continue;
      bool const is_phrase =
          std::any_of(entry.phrases.begin(), entry.phrases.end(),
                      [&](Phrase const& phrase) { return phrase.folded == part || phrase.folded == common; });
      if (is_phrase) return true;
    }
  }
  return false;
}

/// A query that names a fault means a message or a rule rather than the parameter behind it; one that asks
/// for a message means a message.
std::size_t preference(SearchEntry const& entry, SearchQuery const& query) {
  constexpr std::size_t of_a_message = 8;
  constexpr std::size_t of_a_fault = 4;
  bool const is_message = std::holds_alternative<schema::ControlMessage const*>(entry.subject);
  bool const is_rule = std::holds_alternative<validator::Rule const*>(entry.subject);
  if (query.asks_for_message && is_message) return of_a_message;
  return query.tells_fault && (is_message || is_rule) ? of_a_fault : 0;
}

}  // namespace

Coverage coverage(SearchEntry const& entry, SearchQuery const& query) {
  Coverage found;
  for (std::size_t i = 0; i < query.words.size(); ++i) {
    auto const& word = query.words[i];
    auto const& common = query.common_words[i];
    auto points = fit(word, entry);
    if (common != word) points = std::max(points, fit_of_common(common, entry));
    found.fits.push_back(points > 0);
    if (points > 0) ++found.words;
    if (points == in_a_name.whole) found.is_named = true;
    if (points != in_a_name.whole && points != in_a_meaning.whole) found.is_spelled_so = false;
    found.points += points;
  }
  return found;
}

Hit hit_of_words(SearchEntry const& entry, SearchQuery const& query, Coverage const& found) {
  constexpr std::size_t bonus = 6;
  constexpr std::size_t missing_word = 5;
  bool const has_phrase = contains_phrase(entry, query);
  auto const missing = query.words.size() - found.words;
  auto const points = found.points + (has_phrase ? bonus : 0) + (missing == 0 ? preference(entry, query) : 0);
  auto const lost = missing * missing_word;
  return {.subject = entry.subject,
          .likeness = missing == 0 || has_phrase ? Likeness::words : Likeness::some_words,
          .points = points > lost ? points - lost : 0,
          .read_as = {},
          .is_named = has_phrase || (missing == 0 && found.is_named)};
}

}  // namespace axisc
