#include "axisc/answers/explain/search_entries.hpp"

#include "axisc/answers/explain/search_text.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/finding.hpp"
#include "schema/descriptions/description.hpp"
#include "validator/engine/rule_title.hpp"

#include <map>

namespace axisc {

namespace {

using WordsByName = std::map<std::string_view, std::span<std::string_view const>>;

void add_words(std::vector<std::string>& words, std::string_view text) {
  for (auto& word : words_of(text)) words.push_back(std::move(word));
}

void add_words(std::vector<std::string>& words, Page const& page) {
  add_words(words, page.english);
  add_words(words, page.german);
}

void add_name(SearchEntry& entry, std::string_view text) {
  entry.phrases.push_back({.folded = folded(text), .written = std::string(text)});
  add_words(entry.name_words, text);
}

/// Beside the words themselves; parameters and topics describe no faults: "high" in "high cut" is none.
void add_common_words(std::vector<std::string>& words) {
  for (std::size_t i = 0, count = words.size(); i < count; ++i) {
    auto const common = std::string(common_word(words[i]));
    if (common != words[i]) words.push_back(common);
  }
}

/// What people call it, in their words and in common ones.
void add_phrase(SearchEntry& entry, std::string_view text) {
  add_name(entry, text);
  auto common = common_phrase(text);
  if (common != entry.phrases.back().folded) {
    entry.phrases.push_back({.folded = std::move(common), .written = std::string(text), .is_common = true});
  }
}

/// By its name alone.
SearchEntry entry_of(Subject subject, std::string_view name) {
  SearchEntry entry{.subject = subject,
                    .name = ascii::lower_case(name),
                    .phrases = {},
                    .name_parts = {},
                    .name_words = {},
                    .meaning_words = {}};
  add_name(entry, name);
  return entry;
}

class Entries {
 public:
  Entries() {
    for (auto const& row : schema::synonyms()) synonyms_[row.of] = row.words;
  }

  void add(schema::Topic const& topic) {
    auto entry = entry_of(&topic, topic.name);
    for (auto const text : {topic.title.english, topic.title.german}) add_phrase(entry, text);
    for (auto const word : topic.words) add_phrase(entry, word);
    add_words(entry.meaning_words, topic.page);
    entries_.push_back(std::move(entry));
  }

  void add(schema::Parameter const& parameter) {
    auto entry = entry_of(&parameter, parameter.name);
    std::string_view rest = parameter.name;
    while (!rest.empty()) {
      auto const part = rest.substr(0, rest.find('.'));
      entry.name_parts.push_back(
          {.folded = folded(part), .written = std::string(part.substr(0, part.find('[')))});
      rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    }
    add_synonyms(entry, parameter.name);
    auto const number = schema::number_text(parameter.kind, parameter.p_axis);
    if (!number.empty()) add_synonyms(entry, number);
    auto const description = schema::description_of(parameter);
    add_words(entry.meaning_words, description.what);
    add_words(entry.meaning_words, description.detail);
    for (auto const& value : description.values) add_words(entry.meaning_words, value.meaning);
    for (auto const& symbol : parameter.symbols) add_words(entry.meaning_words, symbol.word);
    entries_.push_back(std::move(entry));
  }

  void add(schema::MotionWord const& word) {
    auto entry = entry_of(&word, word.word);
    add_synonyms(entry, word.word);
    add_words(entry.meaning_words, word.meaning.in(Language::english));
    add_words(entry.meaning_words, word.meaning.in(Language::german));
    entries_.push_back(std::move(entry));
  }

  void add(validator::Rule const& rule) {
    auto entry = entry_of(&rule, rule.name);
    for (auto const text : {validator::title(rule).english, validator::title(rule).german}) {
      add_phrase(entry, text);
    }
    add_synonyms(entry, code_text(rule.code));
    auto const& text = validator::page(rule);
    add_words(entry.meaning_words, text.english.substr(0, text.english.find('\n')));
    add_words(entry.meaning_words, text.german.substr(0, text.german.find('\n')));
    add_with_common_words(std::move(entry));
  }

  void add(schema::ControlMessage const& message) {
    auto const number = std::to_string(message.numbers.front());
    auto entry = entry_of(&message, number);
    add_synonyms(entry, number);
    for (auto const& text : {message.meaning, message.remedy}) add_words(entry.meaning_words, text);
    for (auto const parameter : message.parameters) add_words(entry.meaning_words, parameter);
    add_with_common_words(std::move(entry));
  }

  std::vector<SearchEntry> take() && { return std::move(entries_); }

 private:
  void add_with_common_words(SearchEntry entry) {
    add_common_words(entry.name_words);
    add_common_words(entry.meaning_words);
    entries_.push_back(std::move(entry));
  }

  void add_synonyms(SearchEntry& entry, std::string_view name) {
    auto const found = synonyms_.find(name);
    if (found == synonyms_.end()) return;
    for (auto const word : found->second) add_phrase(entry, word);
  }

  WordsByName synonyms_;
  std::vector<SearchEntry> entries_;
};

}  // namespace

std::vector<SearchEntry> search_entries(std::span<schema::Catalogue const> catalogues) {
  Entries entries;
  for (auto const& topic : schema::topics()) entries.add(topic);
  for (auto const& parameter : catalogues.front().parameters()) entries.add(parameter);
  for (auto const& word : schema::motion_words()) entries.add(word);
  for (auto const& rule : validator::rules()) entries.add(rule);
  for (auto const& message : schema::control_messages()) entries.add(message);
  for (auto const& catalogue : catalogues.subspan(1)) {
    for (auto const& parameter : catalogue.parameters()) entries.add(parameter);
  }
  return std::move(entries).take();
}

}  // namespace axisc
