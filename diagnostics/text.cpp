#include "diagnostics/text.hpp"

#include "diagnostics/terminal.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

void append_filled(std::string& text, std::string_view sentence, std::span<Argument const> arguments,
                   Values values) {
  while (true) {
    // Each on its own: the search for one byte is a fast one.
    std::size_t const open = std::min(sentence.find('{'), sentence.size());
    std::size_t const close = std::min(sentence.find('}'), sentence.size());
    std::size_t const brace = std::min(open, close);
    text += sentence.substr(0, brace);
    if (brace == sentence.size()) return;
    bool const is_doubled = sentence.substr(brace + 1).starts_with(sentence[brace]);
    std::size_t end = brace + 1;
    if (is_doubled || brace == close || close == sentence.size()) {
      text += sentence[brace];
      if (is_doubled) ++end;
    } else {
      end = close + 1;
      append_value(text, sentence.substr(brace, end - brace), arguments, values);
    }
    sentence.remove_prefix(end);
  }
}

}  // namespace

std::string_view text_template(Text text, Language language) {
  Entry const& entry = entries.at(static_cast<std::size_t>(text));
  return language == Language::german ? entry.german : entry.english;
}

std::string_view text_key(Text text) {
  return entries.at(static_cast<std::size_t>(text)).key;
}

std::string fill(std::string_view sentence, std::vector<Argument> const& arguments) {
  std::string filled;
  append_filled(filled, sentence, arguments, Values::as_given);
  return filled;
}

void append_rendered(std::string& text, Text sentence, std::span<Argument const> arguments, Language language,
                     Values values) {
  append_filled(text, text_template(sentence, language), arguments, values);
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
