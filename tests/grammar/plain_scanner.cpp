#include "grammar/plain_scanner.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace axisc::test {
namespace {

using namespace grammar;

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
bool is_digit(char c) {
  return '0' <= c && c <= '9';
}
bool is_letter(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_';
}
bool is_hex(char c) {
  return is_digit(c) || ('a' <= c && c <= 'f') || ('A' <= c && c <= 'F');
}

/// A line under a reading position; at() answers 0 behind its end, so no check is forgotten.
struct Line {
  std::string_view text;
  std::size_t position = 0;

  [[nodiscard]] char at(std::size_t index) const { return index < text.size() ? text[index] : '\0'; }
  [[nodiscard]] bool done() const { return position >= text.size(); }
  [[nodiscard]] std::size_t next_blank(std::size_t from) const {
    while (from < text.size() && !is_blank(text[from])) ++from;
    return from;
  }
};

/// End of a run of digits without a leading zero; `from` where there is none.
std::size_t whole_number(std::string_view token, std::size_t from) {
  std::size_t end = from;
  while (end < token.size() && is_digit(token[end])) ++end;
  return end - from > 1 && token[from] == '0' ? from : end;
}

std::size_t digits(std::string_view token, std::size_t from) {
  while (from < token.size() && is_digit(token[from])) ++from;
  return from;
}

/// True if the rest of the token from `from` is an exponent or nothing.
bool exponent_or_end(std::string_view token, std::size_t from) {
  if (from == token.size()) return true;
  if (token[from] != 'e' && token[from] != 'E') return false;
  ++from;
  if (from < token.size() && (token[from] == '+' || token[from] == '-')) ++from;
  return from < token.size() && digits(token, from) == token.size();
}

ValueKind number_kind(std::string_view token) {
  std::size_t const begin = token[0] == '+' || token[0] == '-' ? 1 : 0;
  if (begin == 0 && token.size() > 2 && token[0] == '0' && (token[1] == 'x' || token[1] == 'X')) {
    std::size_t end = 2;
    while (end < token.size() && is_hex(token[end])) ++end;
    if (end == token.size()) return ValueKind::hexadecimal;
  }
  std::size_t const whole = whole_number(token, begin);
  bool const has_whole = whole > begin;
  if (has_whole && whole == token.size()) return ValueKind::integer;
  if (has_whole && token[whole] != '.' && token[whole] != ',') {
    return exponent_or_end(token, whole) ? ValueKind::real : ValueKind::malformed_number;
  }
  if (whole >= token.size()) return ValueKind::malformed_number;
  std::size_t const fraction = digits(token, whole + 1);
  bool const has_fraction = fraction > whole + 1;
  if (token[whole] == '.' && (has_whole || has_fraction) && exponent_or_end(token, fraction)) {
    return ValueKind::real;
  }
  if (token[whole] == ',' && has_whole && has_fraction && exponent_or_end(token, fraction)) {
    return ValueKind::decimal_comma;
  }
  return ValueKind::malformed_number;
}

bool looks_like_number(std::string_view token) {
  std::size_t i = 0;
  if (token[i] == '+' || token[i] == '-') ++i;
  if (i < token.size() && token[i] == '.') ++i;
  return i < token.size() && is_digit(token[i]);
}

bool is_reference(std::string_view word) {
  if (word.substr(0, 7) != "P-AXIS-" || word.size() < 12) return false;
  if (digits(word.substr(0, 12), 7) != 12) return false;
  if (word.size() == 12) return true;
  return word[12] == '.' && word.size() > 13 && digits(word, 13) == word.size();
}

class Scanner {
 public:
  Scanner(std::string_view bytes, bool windows_1252) : bytes_(bytes), windows_1252_(windows_1252) {}

  AxisList scan() {
    list_.assignments.reserve(bytes_.size() / 40);
    std::size_t begin = 0;
    while (begin < bytes_.size()) {
      ++list_.lines;
      std::size_t end = bytes_.find('\n', begin);
      std::size_t const next = end == std::string_view::npos ? bytes_.size() : end + 1;
      if (end == std::string_view::npos) end = bytes_.size();
      if (end > begin && bytes_[end - 1] == '\r') --end;
      while (begin < end && is_blank(bytes_[begin])) ++begin;
      while (end > begin && is_blank(bytes_[end - 1])) --end;
      if (end > begin) scan_line(begin, end);
      begin = next;
    }
    return std::move(list_);
  }

 private:
  void scan_line(std::size_t begin, std::size_t end) {
    offset_ = begin;
    Line line{.text = bytes_.substr(begin, end - begin)};
    if (list_.end_marker) {
      if (line.text[0] != '#') behind_end(0, line.text.size());
      return;
    }
    bool const invalid = invalid_character(line.text);
    std::size_t const first_word = line.next_blank(0);
    if (line.text[0] == '#') {
      directive(line, 0, true);
    } else if (is_end(line.text.substr(0, first_word))) {
      end_of_list(line, first_word, invalid);
    } else if (invalid || !assignment(line, first_word)) {
      std::size_t const opener = std::min({line.text.find('('), line.text.find('#'), line.text.find("/*")});
      if (opener != std::string_view::npos) directive(line, opener, false);
    }
  }

  static bool is_end(std::string_view word) {
    auto const is = [](char c, char small) { return c == small || c == small - 'a' + 'A'; };
    return word.size() == 4 && is(word[0], 'e') && is(word[1], 'n') && is(word[2], 'd') && is(word[3], 'e');
  }

  bool invalid_character(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      auto const byte = static_cast<unsigned char>(text[i]);
      if (0x20 <= byte && byte < 0x7F) continue;
      auto const following = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
      bool const undefined =
          windows_1252_ && std::string_view("\x81\x8D\x8F\x90\x9D").find(text[i]) != std::string_view::npos;
      bool const control = (byte < 0x20 && byte != '\t') || byte == 0x7F;
      bool const high_control = !windows_1252_ && byte == 0xC2 && 0x80 <= following && following <= 0x9F;
      if (undefined || control || high_control) {
        problem(ProblemKind::invalid_character, i, i + (high_control ? 2 : 1));
        return true;
      }
    }
    return false;
  }

  void end_of_list(Line const& line, std::size_t word_end, bool invalid) {
    list_.end_marker = span(0, word_end);
    std::size_t behind = word_end;
    while (behind < line.text.size() && is_blank(line.text[behind])) ++behind;
    if (behind == line.text.size()) return;
    if (line.text[behind] == '#' || line.text[behind] == '(') {
      directive(line, behind, false);
    } else if (!invalid) {
      behind_end(behind, line.text.size());
    }
  }

  void behind_end(std::size_t begin, std::size_t end) {
    for (Problem const& known : list_.problems) {
      if (known.kind == ProblemKind::text_after_end) return;
    }
    problem(ProblemKind::text_after_end, begin, end);
  }

  bool assignment(Line& line, std::size_t name_end) {
    if (!name(line, name_end)) return false;
    std::size_t value = name_end;
    while (value < line.text.size() && is_blank(line.text[value])) ++value;
    char const opener = line.at(value);
    if (opener == '\0' || opener == '(' || opener == '#' || (opener == '/' && line.at(value + 1) == '*')) {
      problem(ProblemKind::expected_value, 0, name_end);
      return false;
    }
    ValueKind kind = ValueKind::other;
    std::size_t const value_end = value_token(line, value, kind);
    if (value_end == 0) {
      problem(ProblemKind::unterminated_string, value, line.text.size());
      return false;
    }
    std::size_t trailer = value_end;
    while (trailer < line.text.size() && is_blank(line.text[trailer])) ++trailer;
    Assignment result;
    result.name = span(0, name_end);
    result.value = span(value, value_end);
    result.kind = kind;
    result.trailer = span(trailer, line.text.size());
    result.trailer_kind = trailer_kind(line, trailer);
    result.line = list_.lines;
    list_.assignments.push_back(result);
    directive(line, trailer, false);
    return true;
  }

  bool name(Line const& line, std::size_t end) {
    std::size_t i = 0;
    while (true) {
      if (i >= end || !is_letter(line.text[i])) break;
      while (i < end && (is_letter(line.text[i]) || is_digit(line.text[i]))) ++i;
      if (i < end && line.text[i] == '[') {
        std::size_t const close = digits(line.text, i + 1);
        if (close == i + 1 || line.at(close) != ']' || line.at(close + 1) == '[') {
          problem(ProblemKind::malformed_index, i, broken_index_end(line, i));
          return false;
        }
        i = close + 1;
      }
      if (i == end) return true;
      if (line.text[i] != '.') break;
      ++i;
    }
    problem(ProblemKind::expected_name, 0, end);
    return false;
  }

  static std::size_t broken_index_end(Line const& line, std::size_t bracket) {
    auto const is_inside = [](char c) { return is_letter(c) || is_digit(c) || c == '+' || c == '-'; };
    std::size_t end = bracket;
    while (line.at(end) == '[') {
      std::size_t i = end + 1;
      while (i < line.text.size() && (is_inside(line.text[i]) || is_blank(line.text[i]))) ++i;
      if (line.at(i) == ']') {
        end = i + 1;
        continue;
      }
      ++end;
      while (end < line.text.size() && is_inside(line.text[end])) ++end;
    }
    return end;
  }

  /// End of the value token; 0 for a quote that is not closed.
  static std::size_t value_token(Line const& line, std::size_t begin, ValueKind& kind) {
    char const first = line.text[begin];
    if (first == '"') {
      std::size_t const quote = line.text.find('"', begin + 1);
      if (quote == std::string_view::npos) return 0;
      char const behind = line.at(quote + 1);
      bool const at_end = quote + 1 == line.text.size();
      kind = at_end || is_blank(behind) || behind == '(' ? ValueKind::quoted : ValueKind::other;
      return kind == ValueKind::quoted ? quote + 1 : line.next_blank(quote + 1);
    }
    std::size_t const blank = line.next_blank(begin);
    if (is_letter(first) || static_cast<unsigned char>(first) >= 0x80) {
      std::size_t const end = std::min(blank, line.text.find('(', begin));
      kind = is_reference(line.text.substr(begin, end - begin)) ? ValueKind::reference : ValueKind::word;
      return end;
    }
    std::string_view const token = line.text.substr(begin, blank - begin);
    kind = looks_like_number(token) ? number_kind(token) : ValueKind::other;
    return blank;
  }

  static TrailerKind trailer_kind(Line const& line, std::size_t begin) {
    if (begin == line.text.size()) return TrailerKind::none;
    switch (line.text[begin]) {
      case '(': return TrailerKind::parenthesis;
      case '#': return TrailerKind::hash;
      case '/': return line.at(begin + 1) == '*' ? TrailerKind::slash_star : TrailerKind::text;
      default: return TrailerKind::text;
    }
  }

  void directive(Line const& line, std::size_t begin, bool whole_line) {
    if (begin == line.text.size()) return;
    if (line.text.find("axisc:", begin) == std::string_view::npos) return;
    list_.directives.push_back(
        {.comment = span(begin, line.text.size()), .whole_line = whole_line, .line = list_.lines});
  }

  void problem(ProblemKind kind, std::size_t begin, std::size_t end) {
    list_.problems.push_back({.kind = kind, .span = span(begin, end), .line = list_.lines});
  }

  [[nodiscard]] Span span(std::size_t begin, std::size_t end) const {
    return {.begin = static_cast<std::uint32_t>(offset_ + begin),
            .end = static_cast<std::uint32_t>(offset_ + end)};
  }

  std::string_view bytes_;
  bool windows_1252_;
  std::size_t offset_ = 0;
  AxisList list_;
};

}  // namespace

AxisList scan_axis_list(std::string_view bytes, bool windows_1252) {
  return Scanner(bytes, windows_1252).scan();
}

}  // namespace axisc::test
