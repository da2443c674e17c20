#include "diagnostics/message.hpp"

#include "diagnostics/terminal.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace axisc {
namespace {

void append_value(std::string& text, std::string_view placeholder, std::span<Argument const> arguments,
                  Language language, Values values) {
  std::string_view const name = placeholder.substr(1, placeholder.size() - 2);
  for (Argument const& argument : arguments) {
    if (argument.name != name) continue;
    std::string const& value = argument.value.in(language);
    if (values == Values::printable) return append_printable(text, value);
    text += value;
    return;
  }
  text += placeholder;
}

}  // namespace

Message counted(std::size_t number, SentenceRef one, SentenceRef many) {
  return {number == 1 ? one : many, {{.name = "count", .value = std::to_string(number)}}};
}

void append_rendered(std::string& text, SentenceRef sentence, std::span<Argument const> arguments,
                     Language language, Values values) {
  std::string_view rest = sentence.in(language);
  bool in_code_span = false;
  for (std::size_t open = rest.find('{'); open != std::string_view::npos; open = rest.find('{')) {
    std::string_view const before = rest.substr(0, open);
    text += before;
    rest.remove_prefix(open);
    in_code_span ^= std::count(before.begin(), before.end(), '`') % 2 != 0;
    std::string_view const placeholder = rest.substr(0, std::min(rest.find('}'), rest.size() - 1) + 1);
    append_value(text, placeholder, arguments, in_code_span ? Language::english : language, values);
    rest.remove_prefix(placeholder.size());
  }
  text += rest;
}

void append_rendered(std::string& text, Message const& message, Language language, Values values) {
  append_rendered(text, message.sentence, message.arguments, language, values);
}

std::string render(Message const& message, Language language, Values values) {
  std::string text;
  append_rendered(text, message, language, values);
  return text;
}

}  // namespace axisc
