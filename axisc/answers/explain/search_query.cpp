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

}  // namespace

SearchQuery search_query(std::string_view text) {
  SearchQuery query{.written = ascii::lower_case(ascii::trimmed(text)),
                    .complete = folded(text),
                    .whole = {},
                    .common = {},
                    .words = {},
                    .common_words = {},
                    .identifiers = identifiers_in(ascii::trimmed(text))};
  if (query.written.find(' ') != std::string::npos) query.common = common_phrase(text);
  for (auto& word : words_of(text)) {
    query.tells_fault = query.tells_fault || tells_a_fault(word);
    query.asks_for_message = query.asks_for_message || asks_for_message(word);
    if (!is_filler(word)) query.words.push_back(std::move(word));
  }
  if (query.words.empty()) query.words = words_of(text);
  query.common_words.reserve(query.words.size());
  for (auto const& word : query.words) {
    query.whole += word;
    query.common_words.emplace_back(common_word(word));
  }
  return query;
}

}  // namespace axisc
