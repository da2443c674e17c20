#include "cli/formats/explain_formats.hpp"

namespace axisc::cli {

namespace {

std::string say(Text text, Language language, std::vector<Argument> arguments = {}) {
  return render({.text = text, .arguments = std::move(arguments)}, language);
}

std::string severity_word(Severity severity, Language language) {
  switch (severity) {
    case Severity::error:
      return say(Text::word_error, language);
    case Severity::warning:
      return say(Text::word_warning, language);
    case Severity::note:
      return say(Text::word_note, language);
  }
  return {};
}

std::string facts(validator::Rule const& rule, Language language) {
  auto text = severity_word(rule.severity, language);
  if (rule.control.empty()) return text;
  bool const several = rule.control.find('/') != std::string_view::npos;
  return text + ", " + say(Text::word_control, language) + ": " +
         say(several ? Text::control_messages : Text::control_message, language,
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
  std::string text =
      "# " + say(Text::explain_all_heading, language) + "\n\n" + say(Text::explain_all_origin, language) +
      "\n\n| " + say(Text::explain_column_code, language) + " | " + say(Text::explain_column_name, language) +
      " | " + say(Text::explain_column_severity, language) + " | " +
      say(Text::explain_column_control, language) + " |\n|---|---|---|---|\n";
  for (auto const& rule : validator::rules()) {
    text += "| [" + code_text(rule.code) + "](#" + code_text(rule.code) + ") | " + std::string(rule.name) +
            " | " + severity_word(rule.severity, language) + " | " + std::string(rule.control) + " |\n";
  }
  for (auto const& rule : validator::rules()) {
    text += "\n<a id=\"" + code_text(rule.code) + "\"></a>\n\n" + explain_rule(rule, 2, language);
  }
  return text;
}

}  // namespace axisc::cli
