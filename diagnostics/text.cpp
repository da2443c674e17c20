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

/// A sentence with placeholders.
struct Template {
  std::string_view text;
  bool has_doubled_braces;  ///< `{{` or `}}`; without them a brace is a placeholder's

  constexpr explicit Template(std::string_view its_text)
      : text(its_text),
        has_doubled_braces(its_text.find("{{") != std::string_view::npos ||
                           its_text.find("}}") != std::string_view::npos) {}
};

struct Entry {
  std::string_view key;
  Template english;
  Template german;
};

constexpr std::array<Entry, static_cast<std::size_t>(Text::count_)> entries{{
#define AXISC_TEXT(key, english, german) Entry{#key, Template(english), Template(german)},
#include "diagnostics/text/all.inc"
#undef AXISC_TEXT
}};

/// Where the next brace stands, or the end.
std::size_t find_brace(std::string_view sentence, bool has_doubled_braces) {
  std::size_t const open = std::min(sentence.find('{'), sentence.size());
  return has_doubled_braces ? std::min(sentence.substr(0, open).find('}'), open) : open;
}

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

void append_filled(std::string& text, Template const& sentence, std::span<Argument const> arguments,
                   Values values) {
  std::string_view rest = sentence.text;
  while (true) {
    std::size_t const brace = find_brace(rest, sentence.has_doubled_braces);
    text += rest.substr(0, brace);
    if (brace == rest.size()) return;
    rest.remove_prefix(brace);
    bool const is_doubled = rest.size() > 1 && rest[1] == rest[0];
    std::size_t const close = rest.find('}');
    if (is_doubled || rest.front() == '}' || close == std::string_view::npos) {
      text += rest.front();
      rest.remove_prefix(is_doubled ? 2 : 1);
    } else {
      append_value(text, rest.substr(0, close + 1), arguments, values);
      rest.remove_prefix(close + 1);
    }
  }
}

Template const& template_of(Text text, Language language) {
  Entry const& entry = entries.at(static_cast<std::size_t>(text));
  return language == Language::german ? entry.german : entry.english;
}

}  // namespace

std::string_view text_template(Text text, Language language) {
  return template_of(text, language).text;
}

std::string_view text_key(Text text) {
  return entries.at(static_cast<std::size_t>(text)).key;
}

std::string fill(std::string_view sentence, std::vector<Argument> const& arguments) {
  std::string filled;
  append_filled(filled, Template(sentence), arguments, Values::as_given);
  return filled;
}

void append_rendered(std::string& text, Text sentence, std::span<Argument const> arguments, Language language,
                     Values values) {
  append_filled(text, template_of(sentence, language), arguments, values);
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
