#include "diagnostics/writers.hpp"

#include <string>

namespace axisc {

std::string whole_message(Finding const& finding, Language language) {
  std::string text = render(finding.message, language);
  auto const add = [&](std::string const& line) { text += '\n' + line; };
  auto const word = [language](Text key) { return render({.text = key, .arguments = {}}, language) + ": "; };
  if (finding.label) add(render(*finding.label, language));
  for (Message const& note : finding.notes) add(render(note, language));
  if (std::string const control = control_text(finding, language); !control.empty()) {
    add(word(Text::word_control) + control);
  }
  for (Message const& help : finding.help) add(word(Text::word_help) + render(help, language));
  if (finding.fix) add(word(Text::word_fix) + render(finding.fix->title, language));
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
