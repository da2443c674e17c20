#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/explain/explain_parts.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/sentences.hpp"
#include "validator/engine/rule_facts.hpp"
#include "validator/engine/rule_title.hpp"

#include <algorithm>
#include <cstddef>

namespace axisc::says {

constexpr Sentence severity_and_control{"{severity}, {control}: {messages}",
                                        "{severity}, {control}: {messages}"};
constexpr Sentence severity_and_many{"{severity}, control: one of {count} messages, by the parameter",
                                     "{severity}, Steuerung: je nach Parameter eine von {count} Meldungen"};
constexpr Sentence rule_title{"{title}.", "{title}."};
constexpr Sentence exceptions{"**Exceptions:** {text}", "**Ausnahmen:** {text}"};
constexpr Sentence no_exceptions{"None: it is reported wherever its condition holds.",
                                 "Keine: gemeldet wird überall, wo die Bedingung zutrifft."};
constexpr Sentence source{"source", "Quelle"};
constexpr Sentence source_list{"{first}; {next}", "{first}; {next}"};
constexpr Sentence reading{"our reading", "unsere Lesart"};
constexpr Sentence own{"our own rule", "unsere eigene Regel"};
constexpr Sentence unreleased{"not yet released", "noch nicht veröffentlicht"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// "Axis filters, section 3.2; FIR filters, section 6.2".
Value sources_of(validator::RuleFacts const& facts) {
  Value all;
  for (auto const source : facts.sources) {
    auto const one = validator::source_text(source);
    all = all.is_nothing() ? Value(one) : Value(Words(says::source_list, {{"first", all}, {"next", one}}));
  }
  return all;
}

Value text_of(Page const& page) {
  return page.english.empty() ? Value() : Value(Wording(page));
}

void add_facts(Section& section, validator::Rule const& rule) {
  auto const& facts = validator::facts(rule);
  auto const exceptions = text_of(facts.exceptions);
  auto const shown = exceptions.is_nothing() ? Value(Words(says::no_exceptions)) : exceptions;
  section.blocks.emplace_back(Paragraph{Words(says::exceptions, {{"text", shown}})});
  section.blocks.emplace_back(Facts{{data("exceptions", exceptions),
                                     {"source", says::source, sources_of(facts)},
                                     {"reading", says::reading, text_of(facts.reading)},
                                     {"own_rule", says::own, text_of(facts.own)},
                                     {"since", says::since, version_of(rule)}}});
}

/// "error, control: message 50663". Many numbers are in the index and in the findings alone.
Words severity_and_messages(validator::Rule const& rule) {
  constexpr std::ptrdiff_t most_shown = 12;
  auto const severity = severity_symbol(rule.severity);
  if (rule.control.empty()) return severity.words;
  auto const slashes = std::count(rule.control.begin(), rule.control.end(), '/');
  if (slashes >= most_shown) {
    return {says::severity_and_many, {{"severity", severity}, {"count", slashes + 1}}};
  }
  return {says::severity_and_control,
          {{"severity", severity},
           {"control", Words(says::word_control)},
           {"messages", Words(slashes > 0 ? says::control_messages : says::control_message,
                              {{"number", rule.control}})}}};
}

}  // namespace

Symbol severity_symbol(Severity severity) {
  auto const name = severity_name(severity);
  switch (severity) {
    case Severity::error: return {name, says::word_error};
    case Severity::warning: return {name, says::word_warning};
    case Severity::note: break;
  }
  return {name, says::word_note};
}

Section rule_section(validator::Rule const& rule) {
  auto const code = code_text(rule.code);
  Section section{
      .key = {},
      .title = as_given(code + " " + std::string(rule.name)),
      .blocks = {Paragraph{Words(says::rule_title, {{"title", Wording(title(rule))}})},
                 Paragraph{severity_and_messages(rule)},
                 Prose{.key = "page", .markdown = Wording(page(rule))}},
      .identity = {data("code", code), data("name", rule.name), data("title", Wording(title(rule))),
                   data("severity", severity_symbol(rule.severity)),
                   data("control", rule.control.empty() ? Value() : Value(rule.control)),
                   data("needs_cycle_time", rule.needs == validator::Needs::cycle_time)},
      .id = code};
  add_facts(section, rule);
  return section;
}

Value version_of(validator::Rule const& rule) {
  auto const version = validator::facts(rule).since;
  return version == "unreleased" ? Value(Symbol{version, says::unreleased}) : Value(version);
}

}  // namespace axisc
