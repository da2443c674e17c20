#include "grammar/regular_line.hpp"

#include "grammar/character_class.hpp"
#include "grammar/invalid_character.hpp"
#include "grammar/text_block.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <string_view>

namespace axisc::grammar {
namespace {

using Bits = std::uint64_t;

/// The bits below `place`.
Bits below(unsigned place) {
  return place >= TextBlock::size ? ~Bits{0} : (Bits{1} << place) - 1;
}

unsigned first_of(Bits bits) {
  return static_cast<unsigned>(std::countr_zero(bits));
}

bool is_one(Bits bits) {
  return std::has_single_bit(bits);
}

bool contains(Bits all, Bits some) {
  return (some & ~all) == 0;
}

/// `name` covers the bytes up to the first blank, the first of which is a letter.
bool is_name(TextBlock const& block, Bits name) {
  Bits const identifier = block.letter | block.digit;
  Bits const point = block.point & name;
  Bits const opening = block.opening & name;
  Bits const closing = block.closing & name;
  if (!contains(identifier | point | opening | closing, name)) return false;
  // A letter behind every point, which is not the last byte then.
  if (!contains(block.letter & name, point << 1U)) return false;
  if ((opening | closing) == 0) return true;
  // Digits fill the brackets, a point or nothing follows them. Of well-formed pairs the difference covers every opening
  // bracket and what stands behind it up to the closing one.
  Bits const inside = closing - opening;
  bool const paired = (inside & opening) == opening && contains(block.digit, inside & ~opening) &&
                      contains(block.digit, opening << 1U);
  return paired && contains(identifier, opening >> 1U) && contains(point, (closing << 1U) & name);
}

/// Digits, with a point among them or without; no zero leads. `number` is not empty.
bool is_decimal(TextBlock const& block, char const* line, Bits number) {
  Bits const point = block.point & number;
  if (!contains(block.digit | point, number) || (point & (point - 1)) != 0 || number == point) return false;
  unsigned const first = first_of(number);
  bool const leads = line[first] == '0' && (block.digit & number & (Bits{2} << first)) != 0;
  return !leads;
}

/// None for what the grammar has to look at.
std::optional<ValueKind> number_kind(TextBlock const& block, char const* line, Bits token) {
  Bits number = token;
  if (is(character::sign, line[first_of(token)])) number &= number - 1;
  if (number == 0) return std::nullopt;
  Bits const letters = block.letter & number;
  if (letters == 0) {
    if (!is_decimal(block, line, number)) return std::nullopt;
    return (block.point & number) != 0 ? ValueKind::real : ValueKind::integer;
  }
  unsigned const letter = first_of(letters);
  Bits const before = number & below(letter);
  Bits behind = number & ~below(letter + 1);
  if (before == 0 || behind == 0) return std::nullopt;
  if (line[letter] == 'x' || line[letter] == 'X') {
    bool const is_prefix = number == token && is_one(before) && line[letter - 1] == '0';
    char const* const end = line + first_of(~token & ~below(letter));
    auto const is_digit = [](char byte) { return is(character::hexadecimal, byte); };
    if (!is_prefix || !std::all_of(line + letter + 1, end, is_digit)) return std::nullopt;
    return ValueKind::hexadecimal;
  }
  if (line[letter] != 'e' && line[letter] != 'E') return std::nullopt;
  if (is(character::sign, line[letter + 1])) behind &= behind - 1;
  if (behind == 0 || !contains(block.digit, behind) || !is_decimal(block, line, before)) return std::nullopt;
  return ValueKind::real;
}

std::optional<ValueKind> value_kind(TextBlock const& block, char const* line, Bits token) {
  char const* const value = line + first_of(token);
  if ((token & (block.unusual | block.quote | block.round)) != 0) return std::nullopt;
  if (!is(character::letter, *value)) return number_kind(block, line, token);
  // Perhaps a reference.
  if (value[0] == 'P' && value[1] == '-') return std::nullopt;
  return ValueKind::word;
}

TrailerKind trailer_kind(char const* trailer, char const* end) {
  if (trailer == end) return TrailerKind::none;
  if (*trailer == '(') return TrailerKind::parenthesis;
  if (*trailer == '#') return TrailerKind::hash;
  bool const is_star = *trailer == '/' && end - trailer > 1 && trailer[1] == '*';
  return is_star ? TrailerKind::slash_star : TrailerKind::text;
}

bool is_end_marker(char const* name, unsigned size) {
  auto const is_letter = [name](unsigned place, char small) { return (name[place] | 0x20) == small; };
  return size == 4 && is_letter(0, 'e') && is_letter(1, 'n') && is_letter(2, 'd') && is_letter(3, 'e');
}

bool is_blank(char byte) {
  return byte == ' ' || byte == '\t';
}

class LineReader {
 public:
  LineReader(char const* text, char const* line, bool windows_1252)
      : text_(text), line_(line), windows_1252_(windows_1252), block_(look_at(line)) {}

  RegularLine read(char const* text_end) {
    if (!find_end(text_end)) return {};
    Bits const content = inside_ & ~block_.blank;
    if (content == 0) {
      if (is_long()) return {};
      result_.shape = RegularLine::Shape::blank;
      return result_;
    }
    unsigned const begin = first_of(content);
    bool const read = line_[begin] == '#' ? read_comment(begin) : read_assignment(begin, content);
    return read ? result_ : RegularLine{};
  }

 private:
  /// Where the line ends without line end and trailing blanks; false in a last line without line end.
  bool find_end(char const* text_end) {
    end_ = line_ + first_of(block_.line_feed);
    if (block_.line_feed == 0) {
      auto const rest = static_cast<std::size_t>(text_end - line_) - TextBlock::size;
      end_ = static_cast<char const*>(std::memchr(line_ + TextBlock::size, '\n', rest));
      if (end_ == nullptr) return false;
    }
    result_.next = end_ + 1;
    if (end_ != line_ && end_[-1] == '\r') --end_;
    while (end_ != line_ && is_blank(end_[-1])) --end_;
    inside_ = is_long() ? ~Bits{0} : below(static_cast<unsigned>(end_ - line_));
    return true;
  }

  /// The line ends outside of the block.
  [[nodiscard]] bool is_long() const { return end_ - line_ > static_cast<std::ptrdiff_t>(TextBlock::size); }

  /// Every character from `begin` on is allowed. `begin` is no place inside a character.
  [[nodiscard]] bool is_clean_from(unsigned begin) const {
    if (!is_long() && (block_.unusual & inside_ & ~below(begin)) == 0) return true;
    std::string_view const rest(line_ + begin, static_cast<std::size_t>(end_ - line_) - begin);
    return !find_invalid_character(rest, windows_1252_);
  }

  bool read_comment(unsigned begin) {
    if (!is_clean_from(begin)) return false;
    result_.shape = RegularLine::Shape::comment;
    result_.assignment.trailer = span(line_ + begin, end_);
    return true;
  }

  bool read_assignment(unsigned name, Bits content) {
    Bits const blank_behind_name = block_.blank & inside_ & ~below(name);
    if ((block_.letter & (Bits{1} << name)) == 0 || blank_behind_name == 0) return false;
    unsigned const name_end = first_of(blank_behind_name);
    if (!is_name(block_, below(name_end) & ~below(name))) return false;
    if (is_end_marker(line_ + name, name_end - name)) return false;

    Bits const behind_name = content & ~below(name_end);
    if (behind_name == 0) return false;
    unsigned const value = first_of(behind_name);
    Bits const blank_behind_value = block_.blank & inside_ & ~below(value);
    if (blank_behind_value == 0 && end_ - line_ >= static_cast<std::ptrdiff_t>(TextBlock::size)) return false;
    unsigned const value_end =
        blank_behind_value == 0 ? static_cast<unsigned>(end_ - line_) : first_of(blank_behind_value);
    auto const kind = value_kind(block_, line_, below(value_end) & ~below(value));
    if (!kind || !is_clean_from(value_end)) return false;

    char const* const free_text_end = find_free_text_end(value, content);
    if (free_text_end == nullptr) return false;
    char const* const trailer = find_trailer(value_end, content);
    Assignment& assignment = result_.assignment;
    assignment.name = span(line_ + name, line_ + name_end);
    assignment.value = span(line_ + value, line_ + value_end);
    assignment.trailer = span(trailer, end_);
    assignment.free_text = span(line_ + value, free_text_end);
    assignment.kind = *kind;
    assignment.trailer_kind = trailer_kind(trailer, end_);
    result_.shape = RegularLine::Shape::assignment;
    return true;
  }

  [[nodiscard]] char const* find_trailer(unsigned value_end, Bits content) const {
    Bits const behind_value = content & ~below(value_end);
    if (behind_value != 0) return line_ + first_of(behind_value);
    if (!is_long()) return end_;
    char const* trailer = line_ + TextBlock::size;
    while (is_blank(*trailer)) ++trailer;
    return trailer;
  }

  /// Behind the last byte that is not blank before the first parenthesis. Null where quotes may protect one.
  [[nodiscard]] char const* find_free_text_end(unsigned value, Bits content) const {
    Bits const marks = (block_.quote | block_.round) & inside_ & ~below(value);
    if (marks != 0) {
      unsigned const mark = first_of(marks);
      if (line_[mark] == '"') return nullptr;
      return line_ + TextBlock::size - std::countl_zero(content & below(mark));
    }
    if (!is_long()) return end_;
    std::string_view const rest(line_ + TextBlock::size,
                                static_cast<std::size_t>(end_ - line_) - TextBlock::size);
    return rest.find_first_of("\"(") == std::string_view::npos ? end_ : nullptr;
  }

  [[nodiscard]] Span span(char const* begin, char const* end) const {
    return {.begin = static_cast<std::uint32_t>(begin - text_),
            .end = static_cast<std::uint32_t>(end - text_)};
  }

  char const* text_;
  char const* line_;
  bool windows_1252_;
  TextBlock block_;
  char const* end_ = nullptr;
  Bits inside_ = 0;  ///< the bytes of the block that belong to the line
  RegularLine result_;
};

}  // namespace

RegularLine read_regular_line(char const* text, char const* line, char const* end, bool windows_1252) {
  return LineReader(text, line, windows_1252).read(end);
}

}  // namespace axisc::grammar
