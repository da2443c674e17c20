#include "axisc/answers/explain/search_query.hpp"

#include "axisc/answers/explain/search_text.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>

namespace axisc {

namespace {

/// "what is slep_max": a name as lists write it is meant, whatever words are around it.
std::vector<std::string> identifiers_in(std::string_view text) {
  std::vector<std::string> identifiers;
  while (!text.empty()) {
    auto const word = text.substr(0, text.find(' '));
    if (word.find('_') != std::string_view::npos) identifiers.push_back(folded(word));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
  }
  return identifiers;
}

/// The whole name of a parameter, `getriebe[0].kv`: words that only its meaning has are not meant.
bool is_path(std::string_view written) {
  auto const point = written.find('.');
  bool const has_blank = written.find(' ') != std::string_view::npos;
  return !has_blank && point != std::string_view::npos && point + 1 < written.size();
}

/// True for "schleppabstadn", which is meant otherwise.
bool mend(TellingWord& word, std::vector<EntryWord> const& known) {
  // Parts of composed words are known.
  if (vocabulary().is_known(word.folded) || word.sense != vocabulary().sense_of(word.folded)) return false;
  auto const own = stem(word.folded);
  bool const is_spelled_so = std::any_of(known.begin(), known.end(), [&](EntryWord const& other) {
    return other.folded.starts_with(word.folded) || stem(other.folded) == own;
  });
  auto const meant = is_spelled_so ? std::string() : vocabulary().nearest(word.folded);
  if (!meant.empty()) word.sense = vocabulary().sense_of(meant);
  return !meant.empty();
}

}  // namespace

SearchQuery search_query(std::string_view text, std::vector<EntryWord> const& known) {
  SearchQuery query{.written = ascii::lower_case(ascii::trimmed(text)),
                    .complete = folded(text),
                    .whole = {},
                    .words = {},
                    .senses = {},
                    .identifiers = identifiers_in(ascii::trimmed(text))};
  for (auto const& word : words_of(text)) {
    query.tells_fault = query.tells_fault || vocabulary().tells_fault(vocabulary().sense_of(word));
  }
  query.is_path = is_path(query.written);
  auto telling = vocabulary().telling_words(text);
  query.asks_for_message = telling.ask_for_message;
  for (auto& word : telling.words) {
    if (!query.whole.ends_with(word.folded)) query.whole += word.folded;
    if (mend(word, known)) query.is_mended = true;
    add_once(query.senses, word.sense);
    if (query.senses.size() > query.words.size()) query.words.push_back(std::move(word));
  }
  return query;
}

}  // namespace axisc
