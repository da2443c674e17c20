#include "diagnostics/text.hpp"

#include "diagnostics/terminal.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

namespace axisc {
namespace {

struct Entry {
  std::string_view key;
  std::string_view english;
  std::string_view german;
};

constexpr std::array<Entry, static_cast<std::size_t>(Text::count_)> entries{{
#define AXISC_TEXT(key, english, german) Entry{#key, english, german},
#include "diagnostics/text/all.inc"
#undef AXISC_TEXT
}};

void append_value(std::string& text, std::string_view placeholder, std::span<Argument const> arguments,
                  Values values) {
  std::string_view const name = placeholder.substr(1, placeholder.size() - 2);
  for (Argument const& argument : arguments) {
    if (argument.name != name) continue;
    if (values == Values::printable) return append_printable(text, argument.value);
    text += argument.value;
    return;
  }
  text += placeholder;
}

}  // namespace

std::string_view text_template(Text text, Language language) {
  Entry const& entry = entries.at(static_cast<std::size_t>(text));
  return language == Language::german ? entry.german : entry.english;
}

std::string_view text_key(Text text) {
  return entries.at(static_cast<std::size_t>(text)).key;
}

void append_rendered(std::string& text, Text sentence, std::span<Argument const> arguments, Language language,
                     Values values) {
  std::string_view rest = text_template(sentence, language);
  for (std::size_t open = rest.find('{'); open != std::string_view::npos; open = rest.find('{')) {
    text += rest.substr(0, open);
    rest.remove_prefix(open);
    std::string_view const placeholder = rest.substr(0, std::min(rest.find('}'), rest.size() - 1) + 1);
    append_value(text, placeholder, arguments, values);
    rest.remove_prefix(placeholder.size());
  }
  text += rest;
}

void append_rendered(std::string& text, Message const& message, Language language, Values values) {
  append_rendered(text, message.text, message.arguments, language, values);
}

std::string render(Message const& message, Language language) {
  std::string text;
  append_rendered(text, message, language);
  return text;
}

}  // namespace axisc
