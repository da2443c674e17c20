#include "axisc/answers/explain/search_text.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace axisc {

namespace {

/// Umlauts and ß have two bytes, of which this is the first; empty for a second byte of other letters.
constexpr char first_byte = '\xC3';

constexpr std::string_view plain_letters(char second_byte) {
  switch (second_byte) {
    case '\xA4':
    case '\x84': return "a";
    case '\xB6':
    case '\x96': return "o";
    case '\xBC':
    case '\x9C': return "u";
    case '\x9F': return "ss";
    default: return {};
  }
}

constexpr std::array<std::string_view, 61> fillers = {
    "a",        "achse",   "alarm",   "am",     "an",    "are",     "at",      "axis",   "bei",
    "bedeutet", "code",    "das",     "den",    "der",   "des",     "die",     "do",     "does",
    "e",        "ein",     "eine",    "einen",  "err",   "error",   "fault",   "fehler", "for",
    "from",     "fur",     "given",   "heisst", "how",   "id",      "im",      "in",     "is",
    "ist",      "kanal",   "macht",   "mean",   "means", "meldung", "message", "mit",    "my",
    "nr",       "of",      "on",      "p",      "set",   "setzen",  "the",     "to",     "und",
    "von",      "warnung", "warning", "was",    "what",  "wie",     "zu"};

}  // namespace

std::string folded(std::string_view text) {
  std::string letters;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == first_byte && i + 1 < text.size()) {
      letters += plain_letters(text[++i]);
    } else if (ascii::is_letter(text[i]) || ascii::is_digit(text[i]) || text[i] == '#') {
      letters += ascii::lower_case(text[i]);
    }
  }
  // People without umlauts on their keyboard write ae, oe, ue.
  std::string result;
  for (char const letter : letters) {
    bool const is_written_out = letter == 'e' && !result.empty() &&
                                std::string_view("aou").find(result.back()) != std::string_view::npos;
    if (!is_written_out) result += letter;
  }
  return result;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  auto const add = [&](std::size_t end) {
    auto word = folded(text.substr(begin, end - begin));
    if (!word.empty()) words.push_back(std::move(word));
    begin = end + 1;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool const is_part = ascii::is_letter(text[i]) || ascii::is_digit(text[i]) || text[i] == '#' ||
                         !ascii::is_printable(text[i]);
    bool const is_blank = text[i] == '\n' || text[i] == '\r' || text[i] == '\t';
    if (!is_part || is_blank) add(i);
  }
  add(text.size());
  return words;
}

bool is_filler(std::string_view folded_word) {
  return std::find(fillers.begin(), fillers.end(), folded_word) != fillers.end();
}

}  // namespace axisc
