// Texts as the search compares them: whatever the keyboard, the case and the hyphens of their writer.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// Letters, digits and `#` alone, in lower case, with ö, oe and o as o (likewise ä and ü) and ß as ss:
/// "Höchst-Geschwindigkeit" and "hoechstgeschwindigkeit" become equal.
[[nodiscard]] std::string folded(std::string_view text);

/// The words of a text as they are written: `getriebe[0].vb_max` has four, "0" being one of them.
[[nodiscard]] std::vector<std::string_view> written_words(std::string_view text);

/// The same, each folded.
[[nodiscard]] std::vector<std::string> words_of(std::string_view text);

/// A folded word without the endings of both languages: "schwingt" and "Schwingungen" become equal, likewise
/// "limits" and "limited". What is left is no word, but the same for all forms.
[[nodiscard]] std::string_view stem(std::string_view folded_word);

/// Digits alone.
[[nodiscard]] bool is_number(std::string_view text);

/// Typing errors that a word of this length may have: none below four letters, one below nine, else two.
[[nodiscard]] constexpr std::size_t accepted_slips(std::size_t length) {
  return length < 4 ? 0 : length < 9 ? 1 : 2;
}

}  // namespace axisc
