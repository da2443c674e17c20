#include "axisc/answers/explain/search.hpp"

#include "axisc/answers/explain/search_entries.hpp"
#include "axisc/answers/explain/search_text.hpp"
#include "diagnostics/ascii.hpp"
#include "schema/edit_distance.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace axisc {

namespace {

struct Query {
  std::string written;   ///< in lower case, without blanks around it
  std::string complete;  ///< folded
  std::string whole;     ///< folded, without fillers
  std::vector<std::string> words;

  [[nodiscard]] bool is(std::string const& text) const { return text == whole || text == complete; }
};

Query query_of(std::string_view text) {
  Query query{
      .written = ascii::lower_case(ascii::trimmed(text)), .complete = folded(text), .whole = {}, .words = {}};
  for (auto& word : words_of(text)) {
    if (!is_filler(word)) query.words.push_back(std::move(word));
  }
  if (query.words.empty()) query.words = words_of(text);
  for (auto const& word : query.words) query.whole += word;
  return query;
}

/// Another number is another message: it has no typing errors.
bool is_number(std::string const& text) {
  return std::all_of(text.begin(), text.end(), ascii::is_digit);
}

/// False for parameters of other kinds of lists, which few people look for.
bool is_of_axes(SearchEntry const& entry) {
  auto const* const parameter = std::get_if<schema::Parameter const*>(&entry.subject);
  return parameter == nullptr || (*parameter)->kind == schema::ListKind::axis;
}

std::optional<Hit> exact_hit(SearchEntry const& entry, Query const& query) {
  bool const is_exact = std::any_of(entry.phrases.begin(), entry.phrases.end(),
                                    [&](Phrase const& phrase) { return query.is(phrase.folded); });
  if (!is_exact) return std::nullopt;
  bool const is_rare = !is_of_axes(entry) && query.is(entry.phrases.front().folded);
  return Hit{.subject = entry.subject,
             .likeness = is_rare ? Likeness::words : Likeness::exact,
             .points = 0,
             .read_as = {}};
}

/// A whole part of the name has three points, the beginning of a part two, anything else one.
std::optional<Hit> part_of_name(SearchEntry const& entry, Query const& query) {
  constexpr std::size_t shortest = 3;
  std::size_t points = 0;
  for (auto const& part : entry.name_parts) {
    if (query.is(part.folded)) points = std::max<std::size_t>(points, 3);
    bool const begins = query.whole.size() >= shortest && part.folded.starts_with(query.whole);
    if (begins) points = std::max<std::size_t>(points, 2);
  }
  bool const is_contained =
      query.written.size() >= shortest && entry.name.find(query.written) != std::string::npos;
  if (points == 0 && is_contained) points = 1;
  if (points == 0) return std::nullopt;
  auto const likeness = is_of_axes(entry) ? Likeness::part_of_name : Likeness::words;
  return Hit{.subject = entry.subject, .likeness = likeness, .points = points, .read_as = {}};
}

constexpr std::size_t most_slips = 2;

/// Fewer errors are better; people's words are better than parts of names.
std::optional<Hit> slip(SearchEntry const& entry, Query const& query) {
  if (is_number(query.whole)) return std::nullopt;
  std::optional<Hit> best;
  auto const look_at = [&](std::string const& text, std::vector<Phrase> const& phrases, std::size_t bonus) {
    auto const accepted = accepted_slips(text.size());
    for (auto const& phrase : phrases) {
      if (accepted == 0 || accepted_slips(phrase.folded.size()) == 0) continue;
      auto const distance = schema::edit_distance(text, phrase.folded, accepted);
      if (distance > accepted) continue;
      auto const points = 2 * (most_slips - distance) + bonus;
      if (best && best->points >= points) continue;
      best = Hit{
          .subject = entry.subject, .likeness = Likeness::slip, .points = points, .read_as = phrase.written};
    }
  };
  for (auto const& text : {query.whole, query.complete}) {
    look_at(text, entry.phrases, 1);
    look_at(text, entry.name_parts, 0);
  }
  return best;
}

bool is_slip_of(std::string const& word, std::string const& known) {
  if (is_number(known)) return false;
  auto const accepted = accepted_slips(word.size());
  auto const [shorter, longer] = std::minmax({word.size(), known.size()});
  return accepted > 0 && longer - shorter <= accepted && accepted_slips(known.size()) > 0 &&
         schema::edit_distance(word, known, accepted) <= accepted;
}

/// How well one of `known` fits a word of the query; German composes: "frequenz" is in "mittenfrequenz".
std::size_t fit(std::string const& word, std::vector<std::string> const& known, std::size_t whole,
                std::size_t beginning, std::size_t part, std::size_t mistyped) {
  constexpr std::size_t shortest_beginning = 3;
  constexpr std::size_t shortest_part = 4;
  std::size_t best = 0;
  for (auto const& other : known) {
    if (other == word) return whole;
    if (is_number(word)) continue;
    bool const begins = word.size() >= shortest_beginning && other.starts_with(word);
    bool const contains = word.size() >= shortest_part && other.find(word) != std::string::npos;
    bool const is_contained = other.size() > shortest_part && word.find(other) != std::string::npos;
    if (begins) best = std::max(best, beginning);
    if (contains || is_contained) best = std::max(best, part);
    if (best < mistyped && is_slip_of(word, other)) best = mistyped;
  }
  return best;
}

struct Coverage {
  std::size_t words = 0;
  std::size_t points = 0;
  bool is_spelled_so = true;  ///< every word that fits is a word there, letter by letter
  bool is_named = false;      ///< one of them is a word of its name, or people's word for it
};

constexpr std::size_t whole_word_of_name = 10;
constexpr std::size_t whole_word_of_meaning = 4;

Coverage coverage(SearchEntry const& entry, Query const& query) {
  Coverage found;
  for (auto const& word : query.words) {
    auto const in_name = fit(word, entry.name_words, whole_word_of_name, 8, 6, 5);
    auto const points =
        in_name > 0 ? in_name : fit(word, entry.meaning_words, whole_word_of_meaning, 3, 2, 1);
    if (points > 0) ++found.words;
    if (points == whole_word_of_name) found.is_named = true;
    if (points != whole_word_of_name && points != whole_word_of_meaning) found.is_spelled_so = false;
    found.points += points;
  }
  return found;
}

/// Several words of the query, one after the other, are its name or people's words for it.
bool contains_phrase(SearchEntry const& entry, Query const& query) {
  constexpr std::size_t shortest = 3;
  for (std::size_t first = 0; first < query.words.size(); ++first) {
    std::string part;
    for (std::size_t i = first; i < query.words.size(); ++i) {
      part += query.words[i];
      if (part.size() < shortest) continue;
      bool const is_phrase = std::any_of(entry.phrases.begin(), entry.phrases.end(),
                                         [&](Phrase const& phrase) { return phrase.folded == part; });
      if (is_phrase) return true;
    }
  }
  return false;
}

/// A phrase makes up for a word that does not fit.
Hit hit_of_words(SearchEntry const& entry, Query const& query, Coverage const& found) {
  constexpr std::size_t bonus = 6;
  constexpr std::size_t missing_word = 5;
  bool const has_phrase = contains_phrase(entry, query);
  auto const missing = query.words.size() - found.words;
  auto const points = found.points + (has_phrase ? bonus : 0);
  auto const lost = missing * missing_word;
  return {.subject = entry.subject,
          .likeness = missing == 0 || has_phrase ? Likeness::words : Likeness::some_words,
          .points = points > lost ? points - lost : 0,
          .read_as = {},
          .is_named = has_phrase || (missing == 0 && found.is_named)};
}

/// The whole name of a parameter, `getriebe[0].kv`: words that only its meaning has are not meant.
bool is_path(Query const& query) {
  auto const point = query.written.find('.');
  bool const has_blank = query.written.find(' ') != std::string::npos;
  return !has_blank && point != std::string::npos && point + 1 < query.written.size();
}

/// Whoever writes a name as programs have it means names.
void keep_names(std::vector<Hit>& hits, Query const& query, bool is_spelled_so) {
  bool const is_identifier = query.written.find_first_of("_.[") != std::string::npos;
  bool const is_in_names = std::any_of(hits.begin(), hits.end(),
                                       [](Hit const& hit) { return hit.likeness == Likeness::part_of_name; });
  if (is_identifier && is_in_names) {
    std::erase_if(hits, [](Hit const& hit) { return hit.likeness > Likeness::part_of_name; });
  }
  if (is_path(query)) std::erase_if(hits, [](Hit const& hit) { return hit.likeness > Likeness::slip; });
  // Words that are spelled as elsewhere are not mistyped.
  bool const is_hyphenated = query.written.find('-') != std::string::npos;
  if (is_spelled_so && !is_hyphenated) {
    std::erase_if(hits, [](Hit const& hit) { return hit.likeness == Likeness::slip; });
  }
}

void sort_hits(std::vector<Hit>& hits) {
  std::stable_sort(hits.begin(), hits.end(), [](Hit const& a, Hit const& b) {
    return std::pair(a.likeness, -static_cast<int>(a.points)) <
           std::pair(b.likeness, -static_cast<int>(b.points));
  });
}

}  // namespace

std::vector<Hit> search(std::span<schema::Catalogue const> catalogues, std::string_view text) {
  return search(search_entries(catalogues), text);
}

std::vector<Hit> search(std::span<SearchEntry const> entries, std::string_view text) {
  auto const query = query_of(text);
  std::vector<Hit> hits;
  std::vector<Hit> partly;
  std::size_t most_words = (query.words.size() + 1) / 2;
  bool is_spelled_so = false;
  if (query.whole.empty()) return hits;
  for (auto const& entry : entries) {
    auto hit = exact_hit(entry, query);
    if (!hit) hit = part_of_name(entry, query);
    auto const found = coverage(entry, query);
    bool const has_all = found.words == query.words.size();
    is_spelled_so = is_spelled_so || (has_all && found.is_spelled_so);
    bool const is_like_it = has_all && found.is_spelled_so && query.written.find('-') == std::string::npos;
    if (!hit && !is_like_it) hit = slip(entry, query);
    if (!hit && found.words > 0) hit = hit_of_words(entry, query, found);
    if (!hit) continue;
    if (hit->likeness != Likeness::some_words) {
      hits.push_back(*std::move(hit));
    } else if (found.words >= most_words) {
      if (found.words > most_words) partly.clear();
      most_words = found.words;
      partly.push_back(*std::move(hit));
    }
  }
  keep_names(hits, query, is_spelled_so);
  if (is_path(query)) partly.clear();
  if (hits.empty()) hits = std::move(partly);
  sort_hits(hits);
  return hits;
}

bool is_answer(std::span<Hit const> hits) {
  if (hits.empty()) return false;
  auto const& first = hits.front();
  bool const is_alone = hits.size() == 1;
  bool const is_alone_of_its_kind = is_alone || hits[1].likeness != first.likeness;
  switch (first.likeness) {
    case Likeness::exact:
    case Likeness::part_of_name: return is_alone_of_its_kind;
    case Likeness::slip: return is_alone_of_its_kind || hits[1].points < first.points;
    case Likeness::words: return is_alone && first.is_named;
    case Likeness::some_words: break;
  }
  return false;
}

}  // namespace axisc
