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

/// One word for all that say that something is wrong, missing, unknown, double, different, too high or too
/// low, in both languages: "no", "ohne" and "missing" become "without". Other words stay.
[[nodiscard]] std::string_view common_word(std::string_view folded_word);

/// The words of a text one after the other, each as its common word, without fillers where at least two
/// others are left: "Gantry slave: no master" and "gantry slave without master" become equal.
[[nodiscard]] std::string common_phrase(std::string_view text);

/// Words of a text that says that something is wrong, folded: "exceeded", "zu", "without".
[[nodiscard]] bool tells_a_fault(std::string_view folded_word);

/// Words by which people ask for a message of the control: "Fehler", "alarm", "error", folded.
[[nodiscard]] bool asks_for_message(std::string_view folded_word);

/// Digits alone.
[[nodiscard]] bool is_number(std::string_view text);

/// Words that say nothing about the subject: "Fehler", "what", "the", "ID".
[[nodiscard]] bool is_filler(std::string_view folded_word);

/// Typing errors that a word of this length may have: none below four letters, one below nine, else two.
[[nodiscard]] constexpr std::size_t accepted_slips(std::size_t length) {
  return length < 4 ? 0 : length < 9 ? 1 : 2;
}

}  // namespace axisc
