#include "axisc/answers/explain/explain_parts.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/finding.hpp"

namespace axisc::says {

constexpr Sentence numbered_message{"Message {number} of the control", "Meldung {number} der Steuerung"};
constexpr Sentence reporter{"reported by", "gemeldet von"};
constexpr Sentence reaction{"what the control does", "was die Steuerung tut"};
constexpr Sentence remedy{"remedy", "Abhilfe"};
constexpr Sentence parameters{"parameters", "Parameter"};
constexpr Sentence undocumented{"not documented", "nicht dokumentiert"};
constexpr Sentence foretold{
    "These findings foretell it; `axisc explain` prints the page of each:",
    "Diese Befunde kündigen die Meldung vorab an; `axisc explain` zeigt die Seite zu jedem:"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

Value text_or(Page const& page, Nothing nothing = {}) {
  return page.english.empty() ? Value(std::move(nothing)) : Value(Wording(page));
}

}  // namespace

Section message_section(std::uint32_t number, schema::ControlMessage const* message,
                        std::span<validator::Rule const* const> foretelling) {
  Section section{
      .key = {}, .title = Words(says::numbered_message, {{"number", std::to_string(number)}}), .blocks = {}};
  section.identity = {data("number", std::to_string(number)),
                      data("meaning", message != nullptr ? text_or(message->meaning) : Value())};
  auto const reporter = schema::reporter_of(number);
  Facts facts{{{"reporter", says::reporter, reporter ? Value(Words(*reporter)) : Value()}}};
  Names parameters;
  if (message != nullptr) {
    section.blocks.emplace_back(Paragraph{as_given(Wording(message->meaning))});
    for (auto const name : message->parameters) parameters.emplace_back(name);
  }
  facts.fields.push_back({"reaction", says::reaction,
                          message != nullptr
                              ? text_or(message->reaction, {.reason = Words(says::undocumented)})
                              : Value(Nothing{.reason = Words(says::undocumented)})});
  facts.fields.push_back({"remedy", says::remedy, message != nullptr ? text_or(message->remedy) : Value()});
  facts.fields.push_back({"parameters", says::parameters, std::move(parameters)});
  Names codes;
  for (auto const* const rule : foretelling) codes.push_back(code_text(rule->code));
  facts.fields.push_back(data("rules", std::move(codes)));
  section.blocks.emplace_back(std::move(facts));
  if (foretelling.empty()) return section;
  section.blocks.emplace_back(Paragraph{says::foretold});
  auto table = subjects_table({}, std::vector<Subject>(foretelling.begin(), foretelling.end()));
  table.audience = Audience::people;
  section.blocks.emplace_back(std::move(table));
  return section;
}

}  // namespace axisc
