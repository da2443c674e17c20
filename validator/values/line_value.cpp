#include "validator/values/line_value.hpp"

#include "diagnostics/ascii.hpp"
#include "grammar/lexical.hpp"
#include "validator/values/short_number.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>

namespace axisc::validator {
namespace {

using grammar::ValueKind;

bool is_integer_kind(ValueKind kind) {
  return kind == ValueKind::integer || kind == ValueKind::hexadecimal;
}

bool was_meant_for_comment(std::string_view text) {
  return text.starts_with(grammar::lexical::hash) || text.starts_with(grammar::lexical::slash_star);
}

/// The place of the first `#` or `/*`; the end where there is none. Texts are too short for a faster search
/// to pay off.
std::size_t comment_opener(std::string_view text) {
  std::size_t place = 0;
  while (place < text.size() && !was_meant_for_comment(text.substr(place))) ++place;
  return place;
}

/// Judges one assignment.
class Judge {
 public:
  Judge(SourceText const& source, grammar::Assignment const& assignment, LineValue& line_value,
        std::forward_list<std::string>& transcoded)
      : source_(source), assignment_(assignment), reading_(line_value), transcoded_(transcoded) {
    reading_.quoted = assignment.kind == ValueKind::quoted;
  }

  void with(schema::Parameter const& parameter) {
    if (assignment_.kind == ValueKind::reference) {
      reading_.status = ReadingStatus::reference;
      reading_.reference = read_reference(token());
    } else if (parameter.type == schema::DataType::boolean) {
      boolean(parameter);
    } else if (parameter.is_enumeration()) {
      enumeration(parameter);
    } else if (parameter.type == schema::DataType::string) {
      free_string();
    } else {
      numeric(parameter);
    }
  }

 private:
  [[nodiscard]] Span free_text() const { return grammar::free_text(source_.bytes(), assignment_); }
  [[nodiscard]] std::string_view token() const { return source_.slice(assignment_.value); }

  /// The bytes themselves if they are UTF-8.
  std::string_view utf8(Span span) {
    std::string_view const bytes = source_.slice(span);
    auto const is_ascii = [](char byte) { return (static_cast<unsigned char>(byte) & 0x80U) == 0; };
    if (std::all_of(bytes.begin(), bytes.end(), is_ascii) || source_.encoding() != Encoding::windows_1252) {
      return bytes;
    }
    return transcoded_.emplace_front(source_.utf8(span));
  }

  /// The token as an integer of any size.
  [[nodiscard]] double integer() const {
    double number = 0;
    bool const is_short =
        assignment_.kind == ValueKind::integer && assignment_.value.end >= room_before_number_end &&
        read_short_integer(token().data(), token().data() + assignment_.value.size(), number);
    return is_short ? number : schema::read_integer(token(), schema::DataType::sgn64).number;
  }

  void fail(ReadingStatus status) { reading_.status = status; }

  void number(schema::NumberReading const& result) {
    reading_.number = result.status;
    reading_.value.number = result.number;
    if (result.status == schema::NumberStatus::good) {
      reading_.status = ReadingStatus::value;
    } else if (result.status == schema::NumberStatus::out_of_data_range) {
      fail(ReadingStatus::out_of_data_range);
    } else {
      fail(ReadingStatus::malformed_number);
    }
  }

  /// True for a malformed number, which is then noted in the line value.
  bool broken_number() {
    if (assignment_.kind == ValueKind::decimal_comma) {
      fail(ReadingStatus::decimal_comma);
      return true;
    }
    if (assignment_.kind != ValueKind::malformed_number) return false;
    reading_.number = schema::read_real(token()).status;
    if (reading_.number == schema::NumberStatus::good) reading_.number = schema::NumberStatus::not_a_number;
    fail(ReadingStatus::malformed_number);
    return true;
  }

  void numeric(schema::Parameter const& parameter) {
    if (broken_number()) return;
    bool const integer = is_integer_kind(assignment_.kind);
    if (!integer && (assignment_.kind != ValueKind::real || schema::is_integer(parameter.type))) {
      fail(ReadingStatus::wrong_type);
    } else if (schema::is_integer(parameter.type)) {
      if (is_unlisted(parameter)) return fail(ReadingStatus::unknown_symbol);
      number(schema::read_integer(token(), parameter.type));
    } else {
      number(schema::read_real(token()));
    }
  }

  /// Where a table of numbers replaces the range, a number that it does not list means nothing.
  [[nodiscard]] bool is_unlisted(schema::Parameter const& parameter) {
    double const value = integer();
    return schema::is_listed_only(parameter) &&
           std::none_of(parameter.number_names.begin(), parameter.number_names.end(),
                        [value](schema::Symbol const& symbol) { return symbol.number == value; });
  }

  void boolean(schema::Parameter const& parameter) {
    if (broken_number()) return;
    if (is_integer_kind(assignment_.kind)) {
      double const value = integer();
      if (value == 0 || value == 1) return accept({.number = value, .text = value == 0 ? "FALSE" : "TRUE"});
      return fail(ReadingStatus::wrong_type);
    }
    if (assignment_.kind != ValueKind::word) return fail(ReadingStatus::wrong_type);
    Span const word{.begin = assignment_.value.begin,
                    .end = std::min(assignment_.value.end, free_text().end)};
    schema::SymbolReading const symbol = schema::read_symbol(parameter, source_.slice(word));
    if (symbol.symbol == nullptr) return fail(ReadingStatus::wrong_type);
    reading_.text = word;
    reading_.symbol_folded = symbol.folded;
    accept(schema::value_of(*symbol.symbol));
    bool const is_truth_value = symbol.symbol->word == "TRUE" || symbol.symbol->word == "FALSE";
    if (!is_truth_value) text_behind_symbol(word.end);
  }

  /// Words of other kinds of lists may begin with digits: `2MBAUD`.
  [[nodiscard]] bool is_word_with_digits(schema::Parameter const& parameter) const {
    return parameter.kind != schema::ListKind::axis &&
           schema::read_symbol(parameter, source_.slice(free_text())).symbol != nullptr;
  }

  void enumeration(schema::Parameter const& parameter) {
    if (!is_word_with_digits(parameter) && broken_number()) return;
    if (is_integer_kind(assignment_.kind)) {
      double const value = integer();
      schema::Symbol const* const symbol = schema::symbol_of_number(parameter, value);
      if (symbol != nullptr) return accept(schema::value_of(*symbol));
      bool const is_mask = schema::is_bit_mask(parameter) && !has_unknown_bits(parameter, value);
      if (is_mask || has_unknown_numbers(parameter)) {
        return accept({.number = value, .text = {}});
      }
      return fail(ReadingStatus::unknown_symbol);
    }
    if (assignment_.kind == ValueKind::real) return fail(ReadingStatus::wrong_type);
    if (joins_words(parameter)) return bit_mask(parameter);

    Span const word =
        reading_.quoted
            ? Span{.begin = assignment_.value.begin + 1, .end = assignment_.value.end - 1}
            : Span{.begin = assignment_.value.begin, .end = std::min(assignment_.value.end, free_text().end)};
    schema::SymbolReading const symbol = schema::read_symbol(parameter, source_.slice(word));
    reading_.text = word;
    std::uint32_t const end = reading_.quoted ? assignment_.value.end : word.end;
    if (symbol.symbol == nullptr) return unknown_symbol(end);
    reading_.symbol_folded = symbol.folded;
    accept(schema::value_of(*symbol.symbol));
    text_behind_symbol(end);
  }

  /// In other kinds of lists words are joined where no document mentions it.
  [[nodiscard]] bool joins_words(schema::Parameter const& parameter) const {
    bool const is_axis = parameter.kind == schema::ListKind::axis;
    if (!is_axis && schema::is_bit_mask(parameter)) return true;
    return (!is_axis || parameter.is_flags) && source_.slice(free_text()).find('|') != std::string_view::npos;
  }

  /// The text itself, without quotes and without a comment behind it.
  [[nodiscard]] Span joined_words() const {
    if (!reading_.quoted) return free_text();
    return {.begin = assignment_.value.begin + 1, .end = assignment_.value.end - 1};
  }

  /// True for a number that is no sum of the words' numbers; those of axis lists are all known.
  [[nodiscard]] static bool has_unknown_bits(schema::Parameter const& parameter, double value) {
    if (parameter.kind != schema::ListKind::axis) return false;
    std::uint64_t known = 0;
    for (schema::Symbol const& symbol : parameter.symbols) {
      if (!symbol.number) return false;
      known |= static_cast<std::uint64_t>(*symbol.number);
    }
    bool const fits = value >= 0 && value <= static_cast<double>(known);
    return !fits || (static_cast<std::uint64_t>(value) & ~known) != 0;
  }

  /// The numbers of a list's words are documented for few of the other kinds of lists.
  [[nodiscard]] static bool has_unknown_numbers(schema::Parameter const& parameter) {
    return parameter.kind != schema::ListKind::axis &&
           std::none_of(parameter.symbols.begin(), parameter.symbols.end(),
                        [](schema::Symbol const& symbol) { return symbol.number.has_value(); });
  }

  void bit_mask(schema::Parameter const& parameter) {
    reading_.text = joined_words();
    if (comment_in_text(reading_.text)) return;
    std::uint64_t bits = 0;
    std::string_view rest = source_.slice(reading_.text);
    while (true) {
      std::size_t const bar = rest.find('|');
      schema::SymbolReading const symbol =
          schema::read_symbol(parameter, ascii::trimmed(rest.substr(0, bar)));
      if (symbol.symbol == nullptr) return fail(ReadingStatus::unknown_symbol);
      reading_.symbol_folded = reading_.symbol_folded || symbol.folded;
      bits |= static_cast<std::uint64_t>(symbol.symbol->number.value_or(0));
      if (bar == std::string_view::npos) break;
      rest.remove_prefix(bar + 1);
    }
    accept({.number = static_cast<double>(bits), .text = utf8(reading_.text)});
    if (reading_.quoted) text_behind_symbol(assignment_.value.end);
  }

  void free_string() {
    if (reading_.quoted) {
      Span const content{.begin = assignment_.value.begin + 1, .end = assignment_.value.end - 1};
      accept({.number = 0, .text = utf8(content)});
      return text_behind_symbol(assignment_.value.end);
    }
    reading_.text = free_text();
    bool const is_glued = assignment_.kind == ValueKind::other && token().starts_with('"');
    if (is_glued) return text_behind_symbol(end_of_quotation());
    if (comment_in_text(free_text())) return;
    accept({.number = 0, .text = utf8(free_text())});
  }

  /// Of `"X"Y`, the place of `Y`.
  [[nodiscard]] std::uint32_t end_of_quotation() const {
    return assignment_.value.begin + static_cast<std::uint32_t>(token().find('"', 1) + 1);
  }

  void accept(schema::Value value) {
    reading_.status = ReadingStatus::value;
    reading_.value = value;
  }

  /// Text after a symbol or a closing quote, before a `(` opens a comment.
  [[nodiscard]] Span text_behind(std::uint32_t symbol_end) const {
    std::uint32_t const begin = reading_.quoted ? assignment_.trailer.begin : symbol_end;
    std::uint32_t const end = reading_.quoted ? assignment_.trailer.end : free_text().end;
    if (begin >= end) return {};
    std::string_view text = source_.slice({.begin = begin, .end = end});
    text = text.substr(0, text.find(grammar::lexical::parenthesis));
    std::string_view const content = ascii::trimmed(text);
    if (content.empty()) return {};
    std::uint32_t const first = begin + static_cast<std::uint32_t>(content.data() - text.data());
    return {.begin = first, .end = first + static_cast<std::uint32_t>(content.size())};
  }

  /// For the control, all this text belongs to the string.
  void text_behind_symbol(std::uint32_t symbol_end) {
    reading_.trouble = text_behind(symbol_end);
    if (!reading_.trouble.empty()) fail(ReadingStatus::comment_in_string);
  }

  /// An unknown word followed by a comment contains two mistakes.
  void unknown_symbol(std::uint32_t symbol_end) {
    fail(ReadingStatus::unknown_symbol);
    Span const text = text_behind(symbol_end);
    if (was_meant_for_comment(source_.slice(text))) reading_.trouble = text;
  }

  /// True where a `#` or `/*` in a free string was meant to open a comment.
  bool comment_in_text(Span span) {
    std::string_view const text = source_.slice(span);
    std::size_t const opener = comment_opener(text);
    if (opener == text.size()) return false;
    reading_.trouble = {.begin = span.begin + static_cast<std::uint32_t>(opener), .end = span.end};
    fail(ReadingStatus::comment_in_string);
    return true;
  }

  SourceText const& source_;
  grammar::Assignment const& assignment_;
  LineValue& reading_;
  std::forward_list<std::string>& transcoded_;
};

}  // namespace

Reference read_reference(std::string_view text) {
  Reference reference;
  constexpr std::size_t prefix = grammar::lexical::reference_prefix.size();
  char const* const end = text.data() + text.size();
  auto const number = std::from_chars(text.data() + std::min(prefix, text.size()), end, reference.p_axis);
  if (number.ptr != end && *number.ptr == '.') {
    // An index too large for a number is out of every range.
    auto const index = std::from_chars(number.ptr + 1, end, reference.index);
    if (index.ec == std::errc::result_out_of_range) reference.index = UINT32_MAX;
  }
  return reference;
}

void judge(SourceText const& source, grammar::Assignment const& assignment, LineValue& line_value,
           std::forward_list<std::string>& transcoded) {
  // Nothing is known about the value of an unknown parameter.
  if (line_value.row_known()) Judge(source, assignment, line_value, transcoded).with(*line_value.row);
}

}  // namespace axisc::validator
