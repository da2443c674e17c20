#include "axisc/answers/explain/search.hpp"

#include "axisc/answers/explain/search_candidates.hpp"
#include "axisc/answers/explain/search_entries.hpp"
#include "axisc/answers/explain/search_text.hpp"
#include "diagnostics/ascii.hpp"
#include "schema/edit_distance.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace axisc {

namespace {

/// False for parameters of other kinds of lists, which few people look for.
bool is_of_axes(SearchEntry const& entry) {
  auto const* const parameter = std::get_if<schema::Parameter const*>(&entry.subject);
  return parameter == nullptr || (*parameter)->kind == schema::ListKind::axis;
}

/// Letter by letter there is more to it than in other words, and more so with its fillers: "Genauhalt ein".
std::size_t exactness(Phrase const& phrase, SearchQuery const& query) {
  if (phrase.folded == query.complete) return 4;
  if (phrase.folded == query.whole) return 3;
  // Whoever writes `filter_fir` means a name, not a FIR filter; whoever says "delay time" means none of those
  // many parameters whose names end in `delay_time`.
  if (!query.identifiers.empty() || phrase.folded.empty()) return 0;
  bool const is_same = !phrase.senses.empty() && phrase.senses.size() == query.senses.size() &&
                       std::is_permutation(phrase.senses.begin(), phrase.senses.end(), query.senses.begin());
  if (!is_same || (phrase.asks_for_message && !query.asks_for_message)) return 0;
  return phrase.senses == query.senses ? 2 : 1;
}

std::optional<Hit> exact_hit(SearchEntry const& entry, SearchQuery const& query) {
  std::size_t best = 0;
  std::string read_as;
  for (auto const& phrase : entry.phrases) {
    auto const found = exactness(phrase, query);
    if (found <= best) continue;
    best = found;
    if (query.is_mended) read_as = phrase.written;
  }
  if (best == 0) return std::nullopt;
  bool const is_rare = !is_of_axes(entry) && query.is(entry.phrases.front().folded);
  // "Alarm Schleppabstand" means a message about it; what else is called so competes by its words.
  bool const is_message = std::holds_alternative<schema::ControlMessage const*>(entry.subject);
  if (query.asks_for_message && !is_message && best < 4) return std::nullopt;
  return Hit{.subject = entry.subject,
             .likeness = is_rare ? Likeness::words : Likeness::exact,
             .points = best - 1,
             .read_as = std::move(read_as)};
}

/// A whole part of the name has three points, the beginning of a part two, anything else one.
std::optional<Hit> part_of_name(SearchEntry const& entry, SearchQuery const& query) {
  constexpr std::size_t shortest = 3;
  std::size_t points = 0;
  for (auto const& part : entry.name_parts) {
    bool const is_identifier =
        std::find(query.identifiers.begin(), query.identifiers.end(), part.folded) != query.identifiers.end();
    if (is_identifier || query.is(part.folded)) points = std::max<std::size_t>(points, 3);
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
std::optional<Hit> slip(SearchEntry const& entry, SearchQuery const& query) {
  if (is_number(query.whole)) return std::nullopt;
  std::optional<Hit> best;
  auto const look_at = [&](std::string const& text, std::vector<Phrase> const& phrases, std::size_t bonus) {
    auto const accepted = accepted_slips(text.size());
    for (auto const& phrase : phrases) {
      bool const is_short = accepted == 0 || accepted_slips(phrase.folded.size()) == 0;
      if (is_short) continue;
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

/// Names are compared letter by letter, whatever their words mean.
bool may_be_mistyped(SearchQuery const& query) {
  return query.is_mended || query.written.find_first_of("-_") != std::string::npos;
}

/// Whoever writes a name as programs have it means names.
void keep_names(std::vector<Hit>& hits, SearchQuery const& query, bool is_spelled_so) {
  bool const is_identifier = query.written.find_first_of("_.[") != std::string::npos;
  bool const is_in_names = std::any_of(hits.begin(), hits.end(),
                                       [](Hit const& hit) { return hit.likeness == Likeness::part_of_name; });
  if (is_identifier && is_in_names) {
    std::erase_if(hits, [](Hit const& hit) { return hit.likeness > Likeness::part_of_name; });
  }
  // A part that is longer or shorter than in the name, `vib_guard.frequency`, is better than nothing.
  bool const is_near_names =
      std::any_of(hits.begin(), hits.end(), [](Hit const& hit) { return hit.likeness <= Likeness::slip; });
  if (is_identifier && is_near_names) {
    std::erase_if(hits, [](Hit const& hit) { return hit.likeness > Likeness::slip; });
  }
  if (query.is_path) {
    std::erase_if(hits, [&](Hit const& hit) {
      bool const is_parameter = std::holds_alternative<schema::Parameter const*>(hit.subject);
      return hit.likeness > (is_near_names ? Likeness::slip : Likeness::words) || !is_parameter ||
             !hit.is_named;
    });
  }
  // Words that are spelled as elsewhere are not mistyped.
  if (is_spelled_so && !may_be_mistyped(query)) {
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

std::vector<Hit> search(SearchEntries const& all, std::string_view text) {
  auto const query = search_query(text, all.words);
  if (query.whole.empty()) return {};
  Fits const fits(query, all.words);
  std::vector<Hit> hits;
  std::vector<Candidate> by_words;
  std::vector<std::size_t> words_of_all(query.words.size());
  bool is_spelled_so = false;
  for (auto const& entry : all.entries) {
    auto hit = exact_hit(entry, query);
    if (!hit) hit = part_of_name(entry, query);
    auto found = coverage(entry, query, fits);
    for (std::size_t i = 0; i < words_of_all.size(); ++i) {
      if (found.points[i] > 0) ++words_of_all[i];
    }
    bool const has_all = found.words == query.words.size() && found.is_spelled_so;
    is_spelled_so = is_spelled_so || has_all;
    if (!hit && (!has_all || may_be_mistyped(query))) hit = slip(entry, query);
    if (hit) {
      hits.push_back(*std::move(hit));
    } else if (found.words > 0) {
      by_words.push_back({.entry = &entry, .found = std::move(found)});
    }
  }
  auto fitting = fitting_words(by_words, words_of_all, query);
  hits.insert(hits.end(), std::make_move_iterator(fitting.begin()), std::make_move_iterator(fitting.end()));
  keep_names(hits, query, is_spelled_so);
  if (hits.size() > 1 && std::any_of(hits.begin(), hits.end(), is_good)) {
    std::erase_if(hits, [](Hit const& hit) { return !is_good(hit); });
  }
  sort_hits(hits);
  return hits;
}

bool is_answer(std::span<Hit const> hits) {
  if (hits.empty()) return false;
  auto const& first = hits.front();
  bool const is_alone = hits.size() == 1;
  bool const is_alone_of_its_kind = is_alone || hits[1].likeness != first.likeness;
  switch (first.likeness) {
    case Likeness::part_of_name: return is_alone_of_its_kind;
    case Likeness::exact:
    case Likeness::slip: return is_alone_of_its_kind || hits[1].points < first.points;
    case Likeness::words: return is_alone && first.is_named;
    case Likeness::some_words: break;
  }
  return false;
}

}  // namespace axisc
