#include "axisc/answers/explain/explain_subject.hpp"

#include "axisc/answers/explain/named_subject.hpp"
#include "axisc/answers/explain/search_entries.hpp"
#include "axisc/answers/explain/search_text.hpp"
#include "axisc/answers/explain/search_vocabulary.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/ascii.hpp"
#include "schema/closest_word.hpp"

#include <algorithm>
#include <utility>

namespace axisc::says {

constexpr Sentence nothing_found{
    "nothing is found for \"{word}\": `axisc explain` knows codes, messages of the control, parameters, "
    "words of NC programs and what they mean; `axisc explain --all` lists the codes",
    "zu „{word}“ ist nichts zu finden: `axisc explain` kennt Codes, Meldungen der Steuerung, Parameter, "
    "Wörter von NC-Programmen und ihre Bedeutung; `axisc explain --all` nennt die Codes"};
constexpr Sentence nothing_found_meant{"nothing is found for \"{word}\"; did you mean {meant}?",
                                       "zu „{word}“ ist nichts zu finden; war {meant} gemeint?"};

}  // namespace axisc::says

namespace axisc {

namespace {

using Catalogues = std::span<schema::Catalogue const>;

/// A message that a row of control-messages.json or a rule names.
bool take_message(ExplainSubject& subject, std::string const& text) {
  auto const number = is_number(text) ? parse_count(text) : std::nullopt;
  if (!number || *number > 0xFFFFFFFFU) return false;
  auto const message = static_cast<std::uint32_t>(*number);
  subject.message = schema::find_control_message(message);
  subject.foretelling = rules_foretelling(text);
  if (subject.message == nullptr && subject.foretelling.empty()) return false;
  subject.number = message;
  return true;
}

/// One word, or one command, as programs write it.
ExplainSubject subject_of(Catalogues catalogues, std::string const& text) {
  ExplainSubject subject;
  subject.motion_word = schema::find_motion_word(std::string_view(text));
  if (subject.motion_word != nullptr) return subject;
  subject.topic = topic_named(text);
  if (subject.topic != nullptr) return subject;
  if (auto const* const rule = rule_named(text)) subject.rules.push_back(rule);
  bool const is_message = take_message(subject, text);
  if (!subject.rules.empty() || is_message) return subject;
  subject.parameters = rows_of_number(catalogues, text);
  if (subject.parameters.empty()) subject.parameters = rows_of_name(catalogues, text);
  return subject;
}

bool is_word_for_parameter(std::string_view word) {
  return word == "parameter" || word == "param" || word == "par";
}

/// The parameters of "axis00440" or "pchan71", folded, which people write without hyphens; "axis2" is an
/// axis.
std::vector<schema::Parameter const*> rows_of_joined_number(Catalogues catalogues, std::string_view word) {
  auto const letters = word.find_first_of("0123456789");
  if (letters == std::string_view::npos || !is_number(word.substr(letters))) return {};
  auto kind = word.substr(0, letters);
  constexpr std::size_t letters_of_a_kind = 4;
  constexpr std::size_t fewest_digits = 3;
  bool const has_p = kind.size() == letters_of_a_kind + 1 && kind.front() == 'p';
  if (has_p) kind.remove_prefix(1);
  bool const is_short = !has_p && word.size() < letters + fewest_digits;
  if (kind.size() != letters_of_a_kind || is_short) return {};
  return rows_of_number(catalogues, "P-" + std::string(kind) + "-" + std::string(word.substr(letters)));
}

/// A number or a word of NC programs in the midst of others: "Fehler 50663", "P-ERR-50663", "what is G60".
/// The number of a message has at least four digits; texts of messages contain others.
ExplainSubject subject_within(Catalogues catalogues, std::string const& text) {
  constexpr std::size_t shortest_message = 4;
  auto const words = words_of(text);
  ExplainSubject subject;
  for (auto const& word : words) {
    subject.parameters = rows_of_joined_number(catalogues, word);
    if (subject.is_found()) return subject;
  }
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    bool const has_prefix = words[i].starts_with('p') && is_number(words[i + 1]);
    if (has_prefix) subject.parameters = rows_of_joined_number(catalogues, words[i] + words[i + 1]);
    if (is_word_for_parameter(words[i]) && is_number(words[i + 1])) {
      subject.parameters = rows_of_number(catalogues, words[i + 1]);
    }
    bool const is_parameter = i > 0 && words[i - 1] == "p" && is_number(words[i + 1]);
    if (is_parameter) subject.parameters = rows_of_number(catalogues, "P-" + words[i] + "-" + words[i + 1]);
    bool const is_rule = words[i] == "ax" || words[i] == "regel" || words[i] == "rule";
    if (is_rule && is_number(words[i + 1])) {
      if (auto const* const rule = rule_named("AX" + words[i + 1])) subject.rules.push_back(rule);
    }
    if (subject.is_found()) return subject;
  }
  for (auto const& word : words) {
    if (word.starts_with("ax") && is_number(std::string_view(word).substr(2))) {
      if (auto const* const rule = rule_named(word)) subject.rules.push_back(rule);
    }
    if (!subject.rules.empty()) return subject;
    if (word.size() >= shortest_message && take_message(subject, word)) return subject;
  }
  std::vector<std::string> telling;
  std::copy_if(words.begin(), words.end(), std::back_inserter(telling),
               [](std::string const& word) { return !vocabulary().is_filler(word); });
  if (telling.size() == 1) return subject_of(catalogues, telling.front());
  for (auto const& word : words) {
    bool const is_g_word = word.starts_with('g') && is_number(std::string_view(word).substr(1));
    if (is_g_word) subject.motion_word = schema::find_motion_word(std::string_view(word));
    if (subject.motion_word != nullptr) return subject;
  }
  return subject;
}

/// A name with a typing error that can mean nothing else.
ExplainSubject subject_nearly_named(Catalogues catalogues, std::string const& text) {
  ExplainSubject subject;
  if (text.find('.') == std::string::npos || text.find(' ') != std::string::npos) return subject;
  auto const near = catalogues.front().suggest_names(text);
  if (!near.is_certain) return subject;
  subject.parameters = rows_of_name(catalogues, near.names.front());
  subject.read_as = near.names.front();
  return subject;
}

void take(ExplainSubject& subject, Subject const& found) {
  struct Taker {
    ExplainSubject& subject;
    void operator()(validator::Rule const* rule) const { subject.rules.push_back(rule); }
    void operator()(schema::Parameter const* parameter) const { subject.parameters.push_back(parameter); }
    void operator()(schema::MotionWord const* word) const { subject.motion_word = word; }
    void operator()(schema::Topic const* topic) const { subject.topic = topic; }
    void operator()(schema::ControlMessage const* message) const {
      subject.message = message;
      subject.number = message->numbers.front();
      subject.foretelling = rules_foretelling(std::to_string(message->numbers.front()));
    }
  };
  std::visit(Taker{subject}, found);
}

/// The answer, with others whose names contain the words, or all hits.
ExplainSubject searched(SearchEntries const& all, std::string const& text) {
  ExplainSubject subject;
  subject.hits = search(all, text);
  if (!is_answer(subject.hits)) return subject;
  auto const answer = subject.hits.front();
  take(subject, answer.subject);
  subject.read_as = answer.read_as;
  subject.hits.erase(subject.hits.begin());
  std::erase_if(subject.hits, [](Hit const& hit) { return hit.likeness != Likeness::part_of_name; });
  return subject;
}

[[noreturn]] void refuse(SearchEntries const& all, std::string const& text) {
  std::vector<std::string> known;
  for (auto const& rule : validator::rules()) known.push_back(code_text(rule.code));
  for (auto const& message : schema::control_messages()) {
    for (auto const number : message.numbers) known.push_back(std::to_string(number));
  }
  for (auto const& entry : all.entries) {
    for (auto const& phrase : entry.phrases) known.push_back(phrase.written);
  }
  auto words = words_of(text);
  std::erase_if(words, [](std::string const& word) { return vocabulary().is_filler(word); });
  std::vector<std::string_view> const views(known.begin(), known.end());
  auto meant = std::string(schema::closest_word(text, views));
  for (auto const& word : words) {
    if (meant.empty()) meant = schema::closest_word(word, views);
  }
  throw Failure(
      {meant.empty() ? says::nothing_found : says::nothing_found_meant, {{"word", text}, {"meant", meant}}});
}

/// Without a search.
ExplainSubject named(Catalogues catalogues, std::string const& text) {
  for (auto const find : {subject_of, subject_within, subject_nearly_named}) {
    auto subject = find(catalogues, text);
    if (subject.is_found()) return subject;
  }
  return {};
}

}  // namespace

ExplainSubject find_subject(std::span<schema::Catalogue const> catalogues, std::string const& text) {
  auto subject = named(catalogues, text);
  return subject.is_found() ? subject : searched(search_entries(catalogues), text);
}

ExplainSubject explain_subject(std::span<schema::Catalogue const> catalogues, std::string const& text) {
  auto subject = named(catalogues, text);
  if (subject.is_found()) return subject;
  auto const all = search_entries(catalogues);
  subject = searched(all, text);
  if (!subject.is_found() && subject.hits.empty()) refuse(all, text);
  return subject;
}

std::optional<Subject> subject_named(std::span<schema::Catalogue const> catalogues, std::string_view name) {
  auto const subject = subject_of(catalogues, std::string(name));
  if (subject.motion_word != nullptr) return subject.motion_word;
  if (subject.topic != nullptr) return subject.topic;
  if (!subject.rules.empty()) return subject.rules.front();
  if (subject.message != nullptr) return subject.message;
  if (!subject.parameters.empty()) return subject.parameters.front();
  return std::nullopt;
}

}  // namespace axisc
