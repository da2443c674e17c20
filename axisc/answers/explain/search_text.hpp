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

/// The words of a text, each folded: `getriebe[0].vb_max` has four, "0" being one of them.
[[nodiscard]] std::vector<std::string> words_of(std::string_view text);

/// Words that say nothing about the subject: "Fehler", "what", "the", "ID".
[[nodiscard]] bool is_filler(std::string_view folded_word);

/// Typing errors that a word of this length may have: none below four letters, one below nine, else two.
[[nodiscard]] constexpr std::size_t accepted_slips(std::size_t length) {
  return length < 4 ? 0 : length < 9 ? 1 : 2;
}

}  // namespace axisc
