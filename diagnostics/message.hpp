// A sentence with its values; the language is chosen when it is written.
#pragma once

#include "diagnostics/sentence.hpp"
#include "diagnostics/wording.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

namespace says {

/// Only its argument `text`: for texts that are the same in both languages, such as a formula, a range or a
/// name.
inline constexpr Sentence as_given{"{text}", "{text}"};

}  // namespace says

/// One value for a placeholder: UTF-8, already formatted for the reader ("12 ms", "`filter[0].order`"). A
/// placeholder in a code span, `{value}`, shows it as lists have it, with a decimal point.
struct Argument {
  std::string_view name;
  Wording value;
};

struct Message {
  SentenceRef sentence = says::as_given;
  std::vector<Argument> arguments = {};
};

/// `one` if the number is 1, otherwise `many`; either has it as {count}.
[[nodiscard]] Message counted(std::size_t number, SentenceRef one, SentenceRef many);

/// Treatment of a sentence's values, which may come from a file; the sentence itself is printable.
enum class Values : std::uint8_t {
  as_given,
  printable,  ///< see printable() in terminal.hpp
};
/// The sentence with its values. A placeholder without a value stays as `{name}` (tests look for it).
[[nodiscard]] std::string render(Message const& message, Language language,
                                 Values values = Values::printable);
/// Appends the rendered sentence to `text`.
void append_rendered(std::string& text, Message const& message, Language language,
                     Values values = Values::as_given);
void append_rendered(std::string& text, SentenceRef sentence, std::span<Argument const> arguments,
                     Language language, Values values = Values::as_given);

}  // namespace axisc
