#include "diagnostics/writers.hpp"

#include <string>

namespace axisc {

std::string whole_message(Finding const& finding, Language language) {
  std::string text;
  auto const begin = [&](Text key) { ((text += '\n') += text_template(key, language)) += ": "; };
  append_rendered(text, finding.message, language);
  if (finding.label) append_rendered(text += '\n', *finding.label, language);
  for (Message const& note : finding.notes) append_rendered(text += '\n', note, language);
  if (has_control_text(finding)) {
    begin(Text::word_control);
    append_control_text(text, finding, language);
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

bool has_control_text(Finding const& finding) {
  if (!finding.control) return false;
  ControlReaction const& control = *finding.control;
  return !control.message.empty() || control.reaction || !control.value.empty();
}

void append_control_text(std::string& text, Finding const& finding, Language language) {
  if (!finding.control) return;
  ControlReaction const& control = *finding.control;
  std::size_t const begin = text.size();
  if (!control.message.empty()) {
    bool const is_one = control.message.find('/') == std::string::npos;
    append_rendered(text,
                    {.text = is_one ? Text::control_message : Text::control_messages,
                     .arguments = {{.name = "number", .value = control.message}}},
                    language);
  }
  if (control.reaction) {
    if (text.size() != begin) text += ": ";
    append_rendered(text, *control.reaction, language);
  }
  if (control.value.empty()) return;
  if (text.size() != begin) text += "; ";
  std::string const value =
      control.physical.empty() ? control.value : control.value + " (" + control.physical + ")";
  append_rendered(text, {.text = Text::control_value, .arguments = {{.name = "value", .value = value}}},
                  language);
}

}  // namespace axisc
