#include "axisc/answers/explain/explain_answer.hpp"

#include "axisc/answers/explain/explain_subject.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/sentences.hpp"
#include "schema/descriptions/description.hpp"

namespace axisc::says {

constexpr Sentence severity_and_control{"{severity}, {control}: {messages}",
                                        "{severity}, {control}: {messages}"};
constexpr Sentence rules{"Rules", "Regeln"};
constexpr Sentence origin{"Every code that axisc reports, as printed by `axisc explain --all`.",
                          "Alle Codes, die axisc meldet, wie `axisc explain --all --lang de` sie ausgibt."};
constexpr Sentence message{"Message {number} of the control", "Meldung {number} der Steuerung"};
constexpr Sentence foretold{
    "These findings foretell it; `axisc explain` prints the page of each:",
    "Diese Befunde kündigen die Meldung vorab an; `axisc explain` zeigt die Seite zu jedem:"};
constexpr Sentence parameters_with{"Parameters with \"{word}\"", "Parameter mit „{word}“"};
constexpr Sentence code{"code", "Code"};
constexpr Sentence severity{"severity", "Schweregrad"};
constexpr Sentence control{"message of the control", "Meldung der Steuerung"};
constexpr Sentence what{"what is found", "was gefunden wird"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

using Rules = std::vector<validator::Rule const*>;

Value text_or_nothing(std::string_view text) {
  return text.empty() ? Value() : Value(text);
}

/// Every code leads to its page, which follows.
Table index_of(Rules const& rules) {
  Table table{.key = {}, .audience = Audience::people};
  for (auto const* const rule : rules) {
    auto code = code_text(rule->code);
    add_row(table,
            {shown(says::code, Link{.text = code, .id = code}), shown(labels::name, rule->name),
             shown(says::severity, severity_symbol(rule->severity)), shown(says::control, rule->control)});
  }
  return table;
}

/// Codes with the first sentence of their pages.
Table foretelling(Rules const& rules) {
  Table table{.key = {}, .audience = Audience::people};
  auto const first_line = [](std::string_view page) { return std::string(page.substr(0, page.find('\n'))); };
  for (auto const* const rule : rules) {
    auto const& text = page(*rule);
    add_row(table, {shown(says::code, code_text(rule->code)), shown(labels::name, rule->name),
                    shown(says::what, Wording(first_line(text.english), first_line(text.german)))});
  }
  return table;
}

Table found(std::vector<schema::Parameter const*> const& parameters) {
  Table table{.key = {}, .audience = Audience::people};
  for (auto const* const parameter : parameters) {
    add_row(table, {shown(labels::parameter, parameter->name),
                    shown(labels::number, schema::number_text(parameter->kind, parameter->p_axis)),
                    shown(labels::meaning, Wording(schema::description_of(*parameter).what))});
  }
  return table;
}

/// Of all kinds of lists, those of axes first.
std::vector<schema::Catalogue> catalogues_of(schema::Catalogue const& of_axes) {
  std::vector<schema::Catalogue> catalogues{of_axes};
  for (auto const& row : schema::list_kind_rows) {
    if (row.kind != schema::ListKind::axis) catalogues.push_back(schema::Catalogue::of(row.kind));
  }
  return catalogues;
}

ExplainSubject everything(schema::Catalogue const& of_axes) {
  ExplainSubject subject;
  for (auto const& rule : validator::rules()) subject.rules.push_back(&rule);
  for (auto const& parameter : of_axes.parameters()) subject.parameters.push_back(&parameter);
  return subject;
}

/// A part that people see alone gives the document its title.
Words take_title(Section& part) {
  auto title = *part.title;
  part.title.reset();
  return title;
}

Document document_of(Section section) {
  Document document{.version = 2, .title = take_title(section), .blocks = {}};
  document.blocks.emplace_back(std::move(section));
  return document;
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
          .blocks = {Paragraph{std::move(facts)}, Prose{.key = "page", .markdown = Wording(page(rule))}},
          .identity = {data("code", code), data("name", rule.name), data("severity", severity),
                       data("control", text_or_nothing(rule.control)),
                       data("needs_cycle_time", rule.needs == validator::Needs::cycle_time)},
          .id = code};
}

Document rule_answer(validator::Rule const& rule) {
  return document_of(rule_section(rule));
}

Document parameter_answer(schema::Catalogue const& catalogue, schema::Parameter const& parameter) {
  return document_of(parameter_section(catalogue, parameter));
}

Document explain_answer(ExplainQuestion const& question) {
  auto const catalogues = catalogues_of(question.of_axes);
  auto const& [word, all, of_axes] = question;
  auto const subject = all ? everything(of_axes) : explain_subject(catalogues, word);
  Document answer{.version = 2, .title = as_given(word), .blocks = {}};
  if (subject.motion_word != nullptr) return word_answer(*subject.motion_word);
  Sections rules{.key = "rules", .items = {}};
  Sections parameters{.key = "parameters", .items = {}};
  for (auto const* const rule : subject.rules) rules.items.push_back(rule_section(*rule));
  for (auto const* const parameter : subject.parameters) {
    parameters.items.push_back(parameter_section(of_axes, *parameter));
    if (all || subject.is_searched) parameters.items.back().audience = Audience::programs;
  }
  Section message{.key = {},
                  .title = Words(says::message, {{"number", word}}),
                  .blocks = {Paragraph{says::foretold}, foretelling(subject.foretelling)}};
  if (all) {
    answer.title = says::rules;
    answer.blocks = {Paragraph{says::origin}, index_of(subject.rules)};
  } else if (subject.is_searched) {
    answer.title = Words(says::parameters_with, {{"word", word}});
    answer.blocks = {found(subject.parameters)};
  } else {
    std::vector<Section*> parts;
    for (auto& item : rules.items) parts.push_back(&item);
    for (auto& item : parameters.items) parts.push_back(&item);
    if (!subject.foretelling.empty()) parts.push_back(&message);
    if (parts.size() == 1) answer.title = take_title(*parts.front());
  }
  for (auto const* const rule : subject.foretelling) {
    rules.items.push_back(rule_section(*rule));
    rules.items.back().audience = Audience::programs;
  }
  answer.csv_table = rules.items.empty() ? "parameters" : "rules";
  // Only the list of all codes has links.
  for (auto& item : rules.items) {
    if (!all) item.id.clear();
  }
  answer.blocks.emplace_back(std::move(rules));
  if (!subject.foretelling.empty()) answer.blocks.emplace_back(std::move(message));
  answer.blocks.emplace_back(std::move(parameters));
  return answer;
}

}  // namespace axisc
