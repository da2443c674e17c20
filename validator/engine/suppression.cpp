#include "validator/engine/suppression.hpp"

#include "diagnostics/ascii.hpp"
#include "schema/edit_distance.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <charconv>

namespace axisc::validator::says {

constexpr Sentence nothing_to_silence{"nothing to silence: there is no {code} on this line",
                                      "hier wird nichts unterdrückt: zu dieser Zeile gibt es kein {code}"};
constexpr Sentence next_line{"nothing to silence: there is no {code} on the next line",
                             "hier wird nichts unterdrückt: zur nächsten Zeile gibt es kein {code}"};
constexpr Sentence unknown{"there is no rule `{code}`", "eine Regel `{code}` gibt es nicht"};
constexpr Sentence empty{"`axisc: allow` does not name a code", "`axisc: allow` nennt keinen Code"};
constexpr Sentence too_many{"a comment silences at most {limit} codes; the rest has no effect",
                            "ein Kommentar unterdrückt höchstens {limit} Codes; der Rest wirkt nicht"};
constexpr Sentence whole_file{"nothing to silence: there is no {code} in this file",
                              "hier wird nichts unterdrückt: in dieser Datei gibt es kein {code}"};
constexpr Sentence no_directive{
    "`axisc: {word}` is not a directive; `axisc: allow` and `axisc: allow-file` are",
    "`axisc: {word}` ist keine Anweisung; es gibt `axisc: allow` und `axisc: allow-file`"};
constexpr Sentence fix{"remove {what}", "{what} entfernen"};
constexpr Sentence fix_word{"write `{what}`", "`{what}` schreiben"};

}  // namespace axisc::validator::says

namespace axisc::validator {
namespace {

constexpr std::string_view blanks = " \t";
constexpr std::string_view allow = "allow";
constexpr std::string_view allow_file = "allow-file";

/// A slip of the pen, or the word of other programs.
bool is_misspelt_directive(std::string_view word) {
  for (std::string_view const other : {"disable", "ignore", "suppress", "off", "noqa", "nolint"}) {
    if (ascii::equal_ignoring_case(word, other)) return true;
  }
  return schema::edit_distance(ascii::lower_case(word), allow, 2) <= 2 ||
         schema::edit_distance(ascii::lower_case(word), allow_file, 3) <= 3;
}

/// More than there are rules.
constexpr std::size_t most_codes = 256;

struct Word {
  std::size_t begin = 0;
  std::size_t end = 0;
};

bool is_code_character(char c) {
  return ascii::is_letter(c) || ascii::is_digit(c) || c == '-';
}

/// The word after `axisc:`; empty if the comment has none.
Word directive_in(std::string_view comment) {
  constexpr std::string_view mark = "axisc:";
  std::size_t const at = comment.find(mark);
  if (at == std::string_view::npos) return {};
  std::size_t const begin = std::min(comment.find_first_not_of(blanks, at + mark.size()), comment.size());
  std::size_t end = begin;
  while (end < comment.size() && is_code_character(comment[end])) ++end;
  return {.begin = begin, .end = end};
}

/// The words of `AX3005, AX2005 because …`: the first one, and each one after a comma.
std::vector<Word> words_of(std::string_view comment, std::size_t from) {
  std::vector<Word> words;
  std::size_t at = from;
  while (true) {
    std::size_t const begin = comment.find_first_not_of(blanks, at);
    if (begin == std::string_view::npos || !is_code_character(comment[begin])) break;
    std::size_t end = begin;
    while (end < comment.size() && is_code_character(comment[end])) ++end;
    words.push_back({.begin = begin, .end = end});
    at = comment.find_first_not_of(blanks, end);
    if (at == std::string_view::npos || comment[at] != ',') break;
    ++at;
  }
  return words;
}

/// Removes the comma and the blanks around a word.
std::string trimmed_entry(std::string_view text) {
  constexpr std::string_view around = " \t,";
  std::size_t const begin = std::min(text.find_first_not_of(around), text.size());
  return std::string(text.substr(begin, text.find_last_not_of(around) + 1 - begin));
}

/// The part that a fix removes from the comment, so that the codes before and after it are still read.
Word removed_with(std::vector<Word> const& words, std::size_t which, std::string_view comment) {
  if (words.size() == 1) {
    std::size_t begin = comment.find("axisc:");
    while (begin > 0 && blanks.find(comment[begin - 1]) != std::string_view::npos) --begin;
    return {.begin = begin, .end = words[0].end};
  }
  if (which == 0) return {.begin = words[0].begin, .end = words[1].begin};
  return {.begin = words[which - 1].end, .end = words[which].end};
}

/// The rule of a code or name in any letter case: "AX3005", "ax3005", "delay-too-long".
Rule const* rule_called(std::string_view word) {
  constexpr std::string_view prefix = "AX";
  std::uint16_t number = 0;
  if (word.size() == code_text({}).size() &&
      ascii::equal_ignoring_case(word.substr(0, prefix.size()), prefix)) {
    auto const [end, error] = std::from_chars(word.data() + prefix.size(), word.data() + word.size(), number);
    if (end == word.data() + word.size() && error == std::errc{}) return find_rule(static_cast<Code>(number));
  }
  for (Rule const& rule : rules()) {
    if (ascii::equal_ignoring_case(word, rule.name)) return &rule;
  }
  return nullptr;
}

}  // namespace

void Suppressions::add(SourceSet const& sources, SourceId source,
                       std::vector<grammar::Directive> const& directives) {
  std::vector<Allowance>& allowances = allowances_[source];
  for (grammar::Directive const& directive : directives) {
    std::string_view const comment = sources[source].slice(directive.comment);
    Word const said = directive_in(comment);
    std::string_view const name = comment.substr(said.begin, said.end - said.begin);
    auto const place_of = [&](Word const& word) {
      return Place{.source = source,
                   .span = {.begin = directive.comment.begin + static_cast<std::uint32_t>(word.begin),
                            .end = directive.comment.begin + static_cast<std::uint32_t>(word.end)}};
    };
    bool const whole_file = name == allow_file;
    if (name != allow && !whole_file) {
      // A word that is far from a directive is a sentence about this program.
      if (!is_misspelt_directive(name)) continue;
      Allowance& mistake = allowances.emplace_back();
      mistake.line = directive.line;
      mistake.place = place_of(said);
      mistake.is_directive = false;
      continue;
    }
    std::size_t const from = said.end;
    std::vector<Word> words = words_of(comment, from);
    if (words.empty()) words.push_back({.begin = from, .end = from});
    if (words.size() > most_codes) {
      Allowance rest;
      rest.is_too_much = true;
      rest.line = directive.line + (directive.whole_line ? 1 : 0);
      rest.place = rest.removed = place_of({.begin = words[most_codes - 1].end, .end = words.back().end});
      allowances.push_back(rest);
      words.resize(most_codes);
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
      Word const& word = words[i];
      Allowance allowance;
      Rule const* const rule = rule_called(comment.substr(word.begin, word.end - word.begin));
      allowance.known = rule != nullptr;
      if (rule != nullptr) allowance.code = rule->code;
      allowance.whole_file = whole_file;
      allowance.next_line = directive.whole_line && !whole_file;
      allowance.line = whole_file ? 0 : directive.line + (allowance.next_line ? 1 : 0);
      allowance.place = place_of(word);
      allowance.removed = place_of(removed_with(words, i, comment));
      allowances.insert(whole_file ? allowances.begin() : allowances.end(), allowance);
    }
  }
}

bool Suppressions::silences(Code code, Place place, SourceSet const& sources) {
  auto const allowances = allowances_.find(place.source);
  if (allowances == allowances_.end() || allowances->second.empty()) return false;
  std::uint32_t const line = sources[place.source].position(place.span.begin).line;
  // Directives come in the order of the lines, and so do the findings that they silence.
  auto allowance =
      std::lower_bound(allowances->second.begin(), allowances->second.end(), line,
                       [](Allowance const& earlier, std::uint32_t wanted) { return earlier.line < wanted; });
  bool silenced = false;
  for (auto each = allowances->second.begin(); each != allowances->second.end() && each->line == 0; ++each) {
    if (each->code != code) continue;
    each->used = true;
    silenced = true;
  }
  for (; allowance != allowances->second.end() && allowance->line == line; ++allowance) {
    if (allowance->code != code) continue;
    allowance->used = true;
    silenced = true;
  }
  return silenced;
}

void Suppressions::report(Allowance const& allowance, SourceSet const& sources, ReportedFindings& reported) {
  Rule const& rule = *find_rule(unused_allowance);
  if (allowance.is_too_much) {
    Report(reported, rule)
        .add(allowance.place, {says::too_many, {{.name = "limit", .value = std::to_string(most_codes)}}});
    return;
  }
  std::string const word = sources[allowance.place.source].utf8(allowance.place.span);
  if (!allowance.is_directive) {
    Finding& finding = Report(reported, *find_rule(unused_allowance))
                           .add(allowance.place, {says::no_directive, {{"word", word}}});
    Fix fix;
    fix.title = {says::fix_word, {{"what", std::string(allow)}}};
    fix.edits.push_back({.place = allowance.place, .text = std::string(allow)});
    finding.fix = std::move(fix);
    return;
  }
  SentenceRef text = allowance.whole_file  ? says::whole_file
                     : allowance.next_line ? says::next_line
                                           : says::nothing_to_silence;
  if (!allowance.known) text = word.empty() ? says::empty : says::unknown;
  Message message{text};
  if (!word.empty()) message.arguments.push_back({.name = "code", .value = word});
  Finding& finding = Report(reported, rule).add(allowance.place, std::move(message));
  std::string const what = sources[allowance.removed.source].utf8(allowance.removed.span);
  Fix fix;
  fix.title = {says::fix, {{"what", '`' + trimmed_entry(what) + '`'}}};
  fix.edits.push_back({.place = allowance.removed, .text = {}});
  fix.safety = FixSafety::safe;
  finding.fix = std::move(fix);
}

}  // namespace axisc::validator
