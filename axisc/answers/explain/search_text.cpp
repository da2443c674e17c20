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

constexpr std::array<std::string_view, 63> fillers = {
    "a",   "achse", "alarm",   "am",      "an",    "are",   "at",   "axis",   "bedeutet", "bei",     "code",
    "das", "den",   "der",     "des",     "die",   "do",    "does", "e",      "ein",      "eine",    "einen",
    "err", "error", "fault",   "fehler",  "for",   "from",  "fur",  "given",  "heisst",   "how",     "id",
    "im",  "in",    "is",      "ist",     "kanal", "macht", "mean", "means",  "meldung",  "message", "mit",
    "msg", "my",    "nr",      "of",      "on",    "p",     "set",  "setzen", "the",      "to",      "too",
    "und", "von",   "warning", "warnung", "was",   "what",  "wie",  "zu"};
static_assert(std::is_sorted(fillers.begin(), fillers.end()));

constexpr std::array<std::string_view, 10> message_words = {
    "alarm", "err", "error", "fault", "fehler", "meldung", "message", "msg", "warning", "warnung"};

/// Sorted by the first word. Comparatives are left out: "smaller than" is a limit, not a fault.
constexpr std::array<std::pair<std::string_view, std::string_view>, 46> common_words = {
    {{"big", "high"},
     {"differ", "different"},
     {"differs", "different"},
     {"doppelt", "twice"},
     {"doppelte", "twice"},
     {"doppelter", "twice"},
     {"double", "twice"},
     {"duplicate", "twice"},
     {"falsch", "invalid"},
     {"falsche", "invalid"},
     {"falscher", "invalid"},
     {"fehlen", "without"},
     {"fehlend", "without"},
     {"fehlende", "without"},
     {"fehlt", "without"},
     {"gross", "high"},
     {"hoch", "high"},
     {"illegal", "invalid"},
     {"incorrect", "invalid"},
     {"kein", "without"},
     {"keine", "without"},
     {"keinen", "without"},
     {"klein", "low"},
     {"large", "high"},
     {"mehrfach", "twice"},
     {"missing", "without"},
     {"niedrig", "low"},
     {"no", "without"},
     {"ohne", "without"},
     {"small", "low"},
     {"unbekannt", "unknown"},
     {"unbekannte", "unknown"},
     {"unbekannter", "unknown"},
     {"unbekanntes", "unknown"},
     {"ungleich", "different"},
     {"ungleiche", "different"},
     {"ungultig", "invalid"},
     {"ungultige", "invalid"},
     {"ungultiger", "invalid"},
     {"unterschiedlich", "different"},
     {"unterschiedliche", "different"},
     {"unzulassig", "invalid"},
     {"verschieden", "different"},
     {"verschiedene", "different"},
     {"wrong", "invalid"},
     {"zweimal", "twice"}}};
static_assert(std::is_sorted(common_words.begin(), common_words.end()));

constexpr std::array<std::string_view, 15> fault_words = {
    "ausserhalb", "cannot", "different",     "exceeded", "impossible", "invalid", "nicht", "not",
    "too",        "twice",  "uberschritten", "unknown",  "unmoglich",  "without", "zu"};

template <std::size_t count>
bool is_one_of(std::array<std::string_view, count> const& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

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

bool is_number(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), ascii::is_digit);
}

std::string_view common_word(std::string_view folded_word) {
  auto const* const found =
      std::lower_bound(common_words.begin(), common_words.end(), folded_word,
                       [](auto const& pair, std::string_view word) { return pair.first < word; });
  return found != common_words.end() && found->first == folded_word ? found->second : folded_word;
}

std::string common_phrase(std::string_view text) {
  auto const words = words_of(text);
  std::string all;
  std::string telling;
  std::size_t count = 0;
  for (auto const& word : words) {
    all += common_word(word);
    if (is_filler(word)) continue;
    telling += common_word(word);
    ++count;
  }
  return count > 1 ? telling : all;
}

bool tells_a_fault(std::string_view folded_word) {
  return is_one_of(fault_words, common_word(folded_word));
}

bool asks_for_message(std::string_view folded_word) {
  return is_one_of(message_words, folded_word);
}

bool is_filler(std::string_view folded_word) {
  return std::binary_search(fillers.begin(), fillers.end(), folded_word);
}

}  // namespace axisc
