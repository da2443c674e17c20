#include "diagnostics/sentences.hpp"
#include "diagnostics/writers/writers.hpp"

#include <array>
#include <string>

namespace axisc::says {

constexpr Sentence control_value{"runs with {value}", "arbeitet mit {value}"};

}  // namespace axisc::says

namespace axisc {

std::string whole_message(Finding const& finding, Language language, Values values) {
  std::string text;
  auto const begin = [&](SentenceRef key) { ((text += '\n') += key.in(language)) += ": "; };
  append_rendered(text, finding.message, language, values);
  if (finding.label) append_rendered(text += '\n', *finding.label, language, values);
  for (Message const& note : finding.notes) append_rendered(text += '\n', note, language, values);
  if (has_control_text(finding)) {
    begin(says::word_control);
    append_control_text(text, finding, language, values);
  }
  for (Message const& help : finding.help) {
    begin(says::word_help);
    append_rendered(text, help, language, values);
  }
  if (finding.fix) {
    begin(says::word_fix);
    append_rendered(text, finding.fix->title, language, values);
  }
  return text;
}

bool has_control_text(Finding const& finding) {
  if (!finding.control) return false;
  ControlReaction const& control = *finding.control;
  return !control.message.empty() || control.reaction || !control.value.empty();
}

void append_control_text(std::string& text, Finding const& finding, Language language, Values values) {
  if (!finding.control) return;
  ControlReaction const& control = *finding.control;
  std::size_t const begin = text.size();
  if (!control.message.empty()) {
    bool const is_one = control.message.find('/') == std::string::npos;
    std::array const number{Argument{.name = "number", .value = control.message}};
    append_rendered(text, is_one ? says::control_message : says::control_messages, number, language, values);
  }
  if (control.reaction) {
    if (text.size() != begin) text += ": ";
    append_rendered(text, *control.reaction, language, values);
  }
  if (control.value.empty()) return;
  if (text.size() != begin) text += "; ";
  std::array value{Argument{.name = "value", .value = Wording::number(control.value)}};
  if (!control.physical.empty()) ((value[0].value += " (") += control.physical) += ")";
  append_rendered(text, says::control_value, value, language, values);
}

}  // namespace axisc
