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

/// Letters, digits, `#` and the bytes of umlauts.
constexpr auto is_of_words = [] {
  std::array<bool, 256> is_part{};
  for (std::size_t i = 0; i < is_part.size(); ++i) {
    auto const letter = static_cast<char>(i);
    is_part[i] = i > 127 || letter == '#' || ascii::is_letter(letter) || ascii::is_digit(letter);
  }
  return is_part;
}();

/// Of both languages, by their last letter, longer ones first.
constexpr std::size_t shortest_stem = 4;
constexpr std::size_t shortest_without_s = 3;
/// Only the last of several endings is long: "filt|er|ing", but "schwing|ung".
constexpr std::size_t longest_of_two = 3;
constexpr std::array<std::string_view, 15> endings = {"end", "ed", "e", "ung",  "ing", "em", "ungen", "en",
                                                      "n",   "er", "r", "ings", "es",  "s",  "t"};

}  // namespace

std::string folded(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == first_byte && i + 1 < text.size()) {
      result += plain_letters(text[++i]);
    } else if (ascii::is_letter(text[i]) || ascii::is_digit(text[i]) || text[i] == '#') {
      char const letter = ascii::lower_case(text[i]);
      // People without umlauts on their keyboard write ae, oe, ue.
      bool const is_written_out = letter == 'e' && !result.empty() &&
                                  std::string_view("aou").find(result.back()) != std::string_view::npos;
      if (!is_written_out) result += letter;
    }
  }
  return result;
}

std::vector<std::string_view> written_words(std::string_view text) {
  std::vector<std::string_view> words;
  std::size_t begin = 0;
  auto const add = [&](std::size_t end) {
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_of_words[static_cast<unsigned char>(text[i])]) add(i);
  }
  add(text.size());
  return words;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (auto const written : written_words(text)) {
    auto word = folded(written);
    if (!word.empty()) words.push_back(std::move(word));
  }
  return words;
}

std::string_view stem(std::string_view folded_word) {
  bool may_be_long = true;
  for (std::size_t before = 0; before != folded_word.size();) {
    before = folded_word.size();
    for (auto const ending : endings) {
      bool const is_plural = may_be_long && ending == "s";
      auto const shortest = is_plural ? shortest_without_s : shortest_stem;
      bool const ends = ending.back() == folded_word.back() &&
                        (may_be_long || ending.size() < longest_of_two) &&
                        folded_word.size() >= shortest + ending.size() && folded_word.ends_with(ending);
      if (!ends) continue;
      folded_word.remove_suffix(ending.size());
      break;
    }
    may_be_long = false;
    auto const size = folded_word.size();
    bool const is_doubled = size > shortest_without_s && folded_word[size - 1] == folded_word[size - 2];
    if (is_doubled) folded_word.remove_suffix(1);
  }
  return folded_word;
}

bool is_number(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), ascii::is_digit);
}

}  // namespace axisc
