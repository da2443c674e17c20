// Every sentence the program can say, in English and German.
//
// The sentences stand in text/*.inc, both languages side by side:
//     AXISC_TEXT(ax3005, "the delay must be shorter than {limit}", "die Verzögerung muss kürzer als {limit}
//     sein")
// which makes Text::ax3005. `{limit}` is a placeholder that a Message fills; both languages name the same
// ones. Braces stand for nothing else. Names: `axNNNN` for the headline of a code, `axNNNN_…` for what stands
// beside it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

enum class Language : std::uint8_t { english, german };

enum class Text : std::uint16_t {
#define AXISC_TEXT(key, english, german) key,
#include "diagnostics/text/all.inc"
#undef AXISC_TEXT
  count_
};

/// One value for a placeholder: UTF-8, already in the form a person reads ("12 ms", "`filter[0].order`").
struct Argument {
  std::string_view name;
  std::string value;
};

/// A sentence with its values; the language is chosen when it is written.
struct Message {
  Text text{};
  std::vector<Argument> arguments;
};

/// The sentence as it stands in the table, placeholders unfilled.
[[nodiscard]] std::string_view text_template(Text text, Language language);
/// The key's own name ("ax3005"), for tests.
[[nodiscard]] std::string_view text_key(Text text);
/// The sentence with its values. A placeholder without a value stays as `{name}` (tests look for it).
[[nodiscard]] std::string render(Message const& message, Language language);
/// What becomes of the values of a sentence, which may come from a file. Its own words are printable.
enum class Values : std::uint8_t {
  as_given,
  printable,  ///< see printable() in terminal.hpp
};
/// The same as render(), behind `text`.
void append_rendered(std::string& text, Message const& message, Language language,
                     Values values = Values::as_given);
void append_rendered(std::string& text, Text sentence, std::span<Argument const> arguments, Language language,
                     Values values = Values::as_given);

}  // namespace axisc
