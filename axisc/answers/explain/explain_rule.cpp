#include "axisc/answers/explain/explain_formats.hpp"
#include "diagnostics/sentences.hpp"

namespace axisc::says {

constexpr Sentence all_heading{"Rules", "Regeln"};
constexpr Sentence all_origin{
    "Every code that axisc reports, as printed by `axisc explain --all`.",
    "Alle Codes, die axisc meldet, wie `axisc explain --all --lang de` sie ausgibt."};
constexpr Sentence message_heading{"Message {number} of the control", "Meldung {number} der Steuerung"};
constexpr Sentence foretold{
    "These findings foretell it; `axisc explain` prints the page of each:",
    "Diese Befunde kündigen die Meldung vorab an; `axisc explain` zeigt die Seite zu jedem:"};
constexpr Sentence column_code{"code", "Code"};
constexpr Sentence column_name{"name", "Name"};
constexpr Sentence column_severity{"severity", "Schweregrad"};
constexpr Sentence column_control{"message of the control", "Meldung der Steuerung"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string say(SentenceRef text, Language language, std::vector<Argument> arguments = {}) {
  return render({.sentence = text, .arguments = std::move(arguments)}, language);
}

std::string severity_word(Severity severity, Language language) {
  switch (severity) {
    case Severity::error:
      return say(says::word_error, language);
    case Severity::warning:
      return say(says::word_warning, language);
    case Severity::note:
      return say(says::word_note, language);
  }
  return {};
}

std::string facts(validator::Rule const& rule, Language language) {
  auto text = severity_word(rule.severity, language);
  if (rule.control.empty()) return text;
  bool const several = rule.control.find('/') != std::string_view::npos;
  return text + ", " + say(says::word_control, language) + ": " +
         say(several ? says::control_messages : says::control_message, language,
             {{"number", std::string(rule.control)}});
}

}  // namespace

std::string explain_rule(validator::Rule const& rule, std::size_t level, Language language) {
  std::string text(level, '#');
  text += " " + code_text(rule.code) + " " + std::string(rule.name) + "\n\n" + facts(rule, language) + "\n";
  auto const body = page(rule).in(language);
  if (body.empty()) return text;
  text += "\n" + std::string(body);
  if (text.back() != '\n') text += '\n';
  return text;
}

std::string explain_all(Language language) {
  std::string text = "# " + say(says::all_heading, language) + "\n\n" + say(says::all_origin, language) +
                     "\n\n| " + say(says::column_code, language) + " | " + say(says::column_name, language) +
                     " | " + say(says::column_severity, language) + " | " +
                     say(says::column_control, language) + " |\n|---|---|---|---|\n";
  for (auto const& rule : validator::rules()) {
    text += "| [" + code_text(rule.code) + "](#" + code_text(rule.code) + ") | " + std::string(rule.name) +
            " | " + severity_word(rule.severity, language) + " | " + std::string(rule.control) + " |\n";
  }
  for (auto const& rule : validator::rules()) {
    text += "\n<a id=\"" + code_text(rule.code) + "\"></a>\n\n" + explain_rule(rule, 2, language);
  }
  return text;
}

std::string explain_message(std::string const& number, std::span<validator::Rule const* const> rules,
                            Language language) {
  auto text = "# " + say(says::message_heading, language, {{"number", number}}) + "\n\n" +
              say(says::foretold, language) + "\n\n";
  for (auto const* const rule : rules) {
    auto const body = page(*rule).in(language);
    text += "- " + code_text(rule->code) + " " + std::string(rule->name) + ": " +
            std::string(body.substr(0, body.find('\n'))) + "\n";
  }
  return text;
}

}  // namespace axisc
