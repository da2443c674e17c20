#include "axisc/answers/explain/explain_answer.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/sentences.hpp"
#include "validator/engine/rule_title.hpp"

namespace axisc::says {

constexpr Sentence severity_and_control{"{severity}, {control}: {messages}",
                                        "{severity}, {control}: {messages}"};
constexpr Sentence rule_title{"{title}.", "{title}."};
constexpr Sentence source{"manual", "Handbuch"};
constexpr Sentence source_list{"{first}; {next}", "{first}; {next}"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// "Axis filters, section 3.2; FIR filters, section 6.2".
Value sources_of(validator::Rule const& rule) {
  Value all;
  for (auto const& section : validator::manual_sections(rule)) {
    Wording const one(section);
    all = all.is_nothing() ? Value(one) : Value(Words(says::source_list, {{"first", all}, {"next", one}}));
  }
  return all;
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
  auto const severity = severity_symbol(rule.severity);
  bool const several = rule.control.find('/') != std::string_view::npos;
  Words facts = severity.words;
  if (!rule.control.empty()) {
    facts = {says::severity_and_control,
             {{"severity", severity},
              {"control", Words(says::word_control)},
              {"messages", Words(several ? axisc::says::control_messages : axisc::says::control_message,
                                 {{"number", rule.control}})}}};
  }
  return {.key = {},
          .title = as_given(code + " " + std::string(rule.name)),
          .blocks = {Paragraph{Words(says::rule_title, {{"title", Wording(title(rule))}})},
                     Paragraph{std::move(facts)}, Prose{.key = "page", .markdown = Wording(page(rule))},
                     Facts{{{"manual", says::source, sources_of(rule)}}}},
          .identity = {data("code", code), data("name", rule.name), data("title", Wording(title(rule))),
                       data("severity", severity),
                       data("control", rule.control.empty() ? Value() : Value(rule.control)),
                       data("needs_cycle_time", rule.needs == validator::Needs::cycle_time)},
          .id = code};
}

}  // namespace axisc
