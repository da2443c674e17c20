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

// Appends what stands at the front of `rest`, a brace or a placeholder, and removes it.
void fill_brace(std::string_view& rest, std::span<Argument const> arguments, Values values,
                std::string& filled) {
  bool const is_doubled = rest.size() > 1 && rest[1] == rest[0];
  std::size_t const close = rest.find('}');
  if (is_doubled || rest.front() == '}' || close == std::string_view::npos) {
    filled += rest.front();
    rest.remove_prefix(is_doubled ? 2 : 1);
    return;
  }
  std::string_view const name = rest.substr(1, close - 1);
  auto const found = std::find_if(arguments.begin(), arguments.end(),
                                  [name](Argument const& argument) { return argument.name == name; });
  if (found == arguments.end()) {
    filled += rest.substr(0, close + 1);
  } else if (values == Values::printable) {
    append_printable(filled, found->value);
  } else {
    filled += found->value;
  }
  rest.remove_prefix(close + 1);
}

void append_filled(std::string& text, std::string_view sentence, std::span<Argument const> arguments,
                   Values values) {
  while (!sentence.empty()) {
    // Each on its own: the search for one byte is a fast one.
    std::size_t const open = std::min(sentence.find('{'), sentence.size());
    std::size_t const plain = std::min(sentence.substr(0, open).find('}'), open);
    text += sentence.substr(0, plain);
    sentence.remove_prefix(plain);
    if (!sentence.empty()) fill_brace(sentence, arguments, values, text);
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
