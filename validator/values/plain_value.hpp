// Values that are beyond doubt, read without the grammar: the token of a line that was cut at its blanks is
// compared with the plain values of its parameter (schema/plain_values.hpp). The grammar and the closer look
// (validator/values/line_value.hpp) read these values the same.
#pragma once

#include "diagnostics/ascii.hpp"
#include "grammar/axis_list.hpp"
#include "grammar/character_class.hpp"
#include "grammar/lexical.hpp"
#include "schema/plain_values.hpp"
#include "schema/words.hpp"
#include "validator/values/line_values.hpp"
#include "validator/values/short_number.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace axisc::validator {

/// The result of reading a plain value.
struct PlainValue {
  double number = 0;
  std::uint8_t text = BriefReading::no_text;
  grammar::ValueKind kind = grammar::ValueKind::word;
};

/// One assignment whose name is known.
class PlainValueReader {
 public:
  PlainValueReader(std::string_view bytes, grammar::Assignment const& assignment)
      : begin_(bytes.data() + assignment.value.begin),
        end_(bytes.data() + assignment.value.end),
        trailer_(assignment.trailer_kind),
        has_room_(assignment.value.end >= room_before_number_end) {}

  /// False if the value has to be judged closely.
  [[nodiscard, gnu::always_inline]] bool read(schema::PlainValues const& values, PlainValue& out) const {
    using schema::PlainKind;
    if (!has_room_ || trailer_ == grammar::TrailerKind::text) return false;
    switch (values.kind) {
      case PlainKind::integer:
        return (short_integer(out) || hexadecimal(out)) && is_within(values, out.number);
      case PlainKind::real: return (short_real(out) || short_integer(out)) && is_within(values, out.number);
      case PlainKind::boolean:
        return digit(out) || (word(values, out) && (out.text <= truth_values || comment_may_follow_word()));
      case PlainKind::symbol: return comment_may_follow_word() && word(values, out);
      case PlainKind::text: return comment_may_follow_word() && text(values, out);
      case PlainKind::none: break;
    }
    return false;
  }

 private:
  using ValueKind = grammar::ValueKind;

  /// FALSE and TRUE are the first words of a boolean; everything after them is a comment.
  static constexpr std::uint8_t truth_values = 2;

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }

  [[nodiscard]] std::string_view text_from(char const* first) const {
    return {first, static_cast<std::size_t>(end_ - first)};
  }

  [[nodiscard]] static bool is_within(schema::PlainValues const& values, double number) {
    return static_cast<bool>(static_cast<unsigned>(values.lowest <= number) &
                             static_cast<unsigned>(number <= values.highest));
  }

  /// After a word only `(` opens a comment.
  [[nodiscard]] bool comment_may_follow_word() const {
    return trailer_ == grammar::TrailerKind::none || trailer_ == grammar::TrailerKind::parenthesis;
  }

  [[nodiscard]] bool has_leading_zero() const {
    char const* const first = begin_ + (digits::is_sign(*begin_) ? 1 : 0);
    return ascii::has_leading_zero(text_from(first));
  }

  bool short_integer(PlainValue& out) const {
    out.kind = ValueKind::integer;
    return read_short_integer(begin_, end_, out.number) && !has_leading_zero();
  }

  bool short_real(PlainValue& out) const {
    out.kind = ValueKind::real;
    return read_short_real(begin_, end_, out.number) && !has_leading_zero();
  }

  /// A hexadecimal number of at most thirteen digits, which a double holds exactly.
  bool hexadecimal(PlainValue& out) const {
    constexpr std::size_t prefix = grammar::lexical::hexadecimal_prefix.size();
    if (size() - prefix - 1 >= 13 || !grammar::lexical::begins_hexadecimal(text_from(begin_))) return false;
    std::uint64_t number = 0;
    for (char const* byte = begin_ + prefix; byte != end_; ++byte) {
      if (!grammar::is(grammar::character::hexadecimal, *byte)) return false;
      // Letters are 0x41 to 0x46 and 0x61 to 0x66, digits 0x30 to 0x39.
      auto const code = static_cast<unsigned char>(*byte);
      number = number << 4U | ((code & 0xFU) + (code >> 6U) * 9U);
    }
    out.number = static_cast<double>(number);
    out.kind = ValueKind::hexadecimal;
    return true;
  }

  /// 0 or 1.
  bool digit(PlainValue& out) const {
    auto const value = static_cast<unsigned>(static_cast<unsigned char>(*begin_)) - '0';
    if (size() != 1 || value > 1) return false;
    out = {.number = static_cast<double>(value),
           .text = static_cast<std::uint8_t>(1 + value),
           .kind = ValueKind::integer};
    return true;
  }

  bool word(schema::PlainValues const& values, PlainValue& out) const {
    if (!grammar::is(grammar::character::letter, *begin_)) return false;
    for (schema::Symbol const& symbol : values.words()) {
      if (symbol.word.size() != size() || !schema::same_bytes(symbol.word.data(), begin_, size())) continue;
      out = {.number = static_cast<double>(symbol.number.value_or(0)),
             .text = static_cast<std::uint8_t>(&symbol - values.symbols + 1),
             .kind = ValueKind::word};
      return true;
    }
    return false;
  }

  /// Letters, digits and the characters allowed between them; not a reference.
  bool text(schema::PlainValues const& values, PlainValue& out) const {
    using namespace grammar;
    bool const may_be_reference = text_from(begin_).starts_with(lexical::parameter_number_prefix);
    if (!is(character::letter, *begin_) || may_be_reference || size() > values.longest) return false;
    for (char const* byte = begin_ + 1; byte != end_; ++byte) {
      if (!is(character::letter | character::digit | character::sign, *byte) &&
          *byte != lexical::decimal_point) {
        return false;
      }
    }
    out = {.number = 0, .text = BriefReading::own_text, .kind = ValueKind::word};
    return true;
  }

  char const* begin_;
  char const* end_;
  grammar::TrailerKind trailer_;
  bool has_room_;
};

}  // namespace axisc::validator
