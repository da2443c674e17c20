#include "axisc/answers/explain/search_entries.hpp"

#include "axisc/answers/explain/search_entry_words.hpp"
#include "axisc/answers/explain/search_text.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/finding.hpp"
#include "schema/descriptions/description.hpp"
#include "validator/engine/rule_title.hpp"

#include <map>

namespace axisc {

namespace {

using WordsByName = std::map<std::string_view, std::span<std::string_view const>>;

class Entries {
 public:
  Entries() {
    for (auto const& row : schema::synonyms()) synonyms_[row.of] = row.words;
  }

  void add(schema::Topic const& topic) {
    auto entry = entry_of(&topic, topic.name);
    for (auto const text : {topic.title.english, topic.title.german}) add_phrase(entry, text);
    for (auto const word : topic.words) add_phrase(entry, word);
    add_meaning(entry, topic.page);
    all_.entries.push_back(std::move(entry));
  }

  void add(schema::Parameter const& parameter) {
    SearchEntry entry{.subject = &parameter, .name = ascii::lower_case(parameter.name)};
    entry.phrases.push_back(
        {.folded = folded(parameter.name), .written = std::string(parameter.name), .senses = {}});
    std::string_view rest = parameter.name;
    while (!rest.empty()) {
      auto const part = rest.substr(0, rest.find('.'));
      bool const is_first = entry.name_parts.empty() && part.size() < rest.size();
      entry.name_parts.push_back(
          {.folded = folded(part), .written = std::string(part.substr(0, part.find('['))), .senses = {}});
      // `getriebe` and `kenngr` begin hundreds of names and say little about them.
      if (is_first) {
        words_.add_meaning(entry.meaning_words, part);
      } else {
        words_.add_name(entry.name_words, part);
      }
      rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    }
    if (parameter.kind == schema::ListKind::axis) add_last_part(entry);
    add_synonyms(entry, parameter.name);
    auto const number = schema::number_text(parameter.kind, parameter.p_axis);
    if (!number.empty()) add_synonyms(entry, number);
    auto const description = schema::description_of(parameter);
    add_meaning(entry, description.what);
    add_meaning(entry, description.detail);
    for (auto const& value : description.values) add_meaning(entry, value.meaning);
    for (auto const& symbol : parameter.symbols) words_.add_meaning(entry.meaning_words, symbol.word);
    all_.entries.push_back(std::move(entry));
  }

  void add(schema::MotionWord const& word) {
    auto entry = entry_of(&word, word.word);
    add_synonyms(entry, word.word);
    words_.add_meaning(entry.meaning_words, word.meaning.in(Language::english));
    words_.add_meaning(entry.meaning_words, word.meaning.in(Language::german));
    all_.entries.push_back(std::move(entry));
  }

  void add(validator::Rule const& rule) {
    auto entry = entry_of(&rule, rule.name);
    entry.is_about_fault = true;
    for (auto const text : {validator::title(rule).english, validator::title(rule).german}) {
      add_phrase(entry, text);
    }
    add_synonyms(entry, code_text(rule.code));
    auto const& text = validator::page(rule);
    words_.add_meaning(entry.meaning_words, text.english.substr(0, text.english.find('\n')));
    words_.add_meaning(entry.meaning_words, text.german.substr(0, text.german.find('\n')));
    all_.entries.push_back(std::move(entry));
  }

  void add(schema::ControlMessage const& message) {
    auto const number = std::to_string(message.numbers.front());
    auto entry = entry_of(&message, number);
    entry.is_about_fault = true;
    add_synonyms(entry, number);
    for (auto const& text : {message.meaning, message.remedy}) add_meaning(entry, text);
    for (auto const parameter : message.parameters) words_.add_meaning(entry.meaning_words, parameter);
    all_.entries.push_back(std::move(entry));
  }

  SearchEntries take() && {
    all_.words = std::move(words_).take();
    return std::move(all_);
  }

 private:
  /// By its name alone.
  SearchEntry entry_of(Subject subject, std::string_view name) {
    SearchEntry entry{.subject = subject, .name = ascii::lower_case(name)};
    entry.phrases.push_back({.folded = folded(name), .written = std::string(name), .senses = {}});
    words_.add_name(entry.name_words, name);
    return entry;
  }

  /// Of topics and parameters "high" and its like mean themselves alone.
  void add_phrase(SearchEntry& entry, std::string_view text) {
    Phrase phrase{.folded = folded(text), .written = std::string(text), .senses = {}};
    auto const telling = vocabulary().telling_words(text);
    bool const is_message = std::holds_alternative<schema::ControlMessage const*>(entry.subject);
    phrase.asks_for_message = is_message && telling.ask_for_message;
    for (auto const& word : telling.words) {
      bool const is_itself = !entry.is_about_fault && vocabulary().is_of_faults(word.sense);
      auto const sense = is_itself ? sense_as_spelled(word.folded) : word.sense;
      add_once(phrase.senses, sense);
      words_.add_word_of_name(entry.name_words, word.folded);
    }
    entry.phrases.push_back(std::move(phrase));
  }

  /// `temp_comp_coefficient` says as much as people's words, `order` does not.
  void add_last_part(SearchEntry& entry) {
    auto const& part = entry.name_parts.back().written;
    if (part.find('_') == std::string::npos) return;
    add_phrase(entry, part);
    entry.phrases.back().folded.clear();
  }

  void add_meaning(SearchEntry& entry, Page const& page) {
    words_.add_meaning(entry.meaning_words, page.english);
    words_.add_meaning(entry.meaning_words, page.german);
  }

  void add_synonyms(SearchEntry& entry, std::string_view name) {
    auto const found = synonyms_.find(name);
    if (found == synonyms_.end()) return;
    for (auto const word : found->second) add_phrase(entry, word);
  }

  WordsByName synonyms_;
  EntryWords words_;
  SearchEntries all_;
};

}  // namespace

SearchEntries search_entries(std::span<schema::Catalogue const> catalogues) {
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
