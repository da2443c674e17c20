#include "diagnostics/writers.hpp"

#include <string>

namespace axisc {

std::string whole_message(Finding const& finding, Language language) {
  std::string text;
  auto const begin = [&](Text key) { ((text += '\n') += text_template(key, language)) += ": "; };
  append_rendered(text, finding.message, language);
  if (finding.label) append_rendered(text += '\n', *finding.label, language);
  for (Message const& note : finding.notes) append_rendered(text += '\n', note, language);
  if (std::string const control = control_text(finding, language); !control.empty()) {
    begin(Text::word_control);
    text += control;
  }
  for (Message const& help : finding.help) {
    begin(Text::word_help);
    append_rendered(text, help, language);
  }
  if (finding.fix) {
    begin(Text::word_fix);
    append_rendered(text, finding.fix->title, language);
  }
  return text;
}

std::string control_text(Finding const& finding, Language language) {
  if (!finding.control) return {};
  ControlReaction const& control = *finding.control;
  std::string text;
  if (!control.message.empty()) {
    bool const is_one = control.message.find('/') == std::string::npos;
    text += render({.text = is_one ? Text::control_message : Text::control_messages,
                    .arguments = {{.name = "number", .value = control.message}}},
                   language);
  }
  if (control.reaction) {
    if (!text.empty()) text += ": ";
    text += render(*control.reaction, language);
  }
  if (!control.value.empty()) {
    if (!text.empty()) text += "; ";
    std::string const value =
        control.physical.empty() ? control.value : control.value + " (" + control.physical + ")";
    text += render({.text = Text::control_value, .arguments = {{.name = "value", .value = value}}}, language);
  }
  return text;
}

}  // namespace axisc
