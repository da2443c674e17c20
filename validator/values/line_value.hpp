// The meaning of one assignment of a list, judged with the catalogue: before any other line is looked at.
#pragma once

#include "diagnostics/source_text.hpp"
#include "grammar/axis_list.hpp"
#include "schema/catalogue.hpp"
#include "schema/value.hpp"

#include <cstdint>
#include <forward_list>
#include <string>
#include <string_view>

namespace axisc::validator {

enum class ReadingStatus : std::uint8_t {
  value,              ///< `value` holds what the control reads
  reference,          ///< the value of another parameter, to be looked up in the effective values
  not_judged,         ///< the name is unknown, so nothing is known about the value
  decimal_comma,      ///< AX1005
  malformed_number,   ///< AX1006, with its reason in `number`
  comment_in_string,  ///< AX1009, see `trouble`
  wrong_type,         ///< AX2003
  out_of_data_range,  ///< AX2004
  unknown_symbol,     ///< AX2007
};

/// A reference as written in a list: P-AXIS-00212.1.
struct Reference {
  std::uint32_t p_axis = 0;
  std::uint32_t index = 0;
};
[[nodiscard]] Reference read_reference(std::string_view text);

struct LineValue {
  using NameStatus = schema::NameLookup::Status;

  schema::Parameter const* row = nullptr;  ///< null where the name is unknown; lives as long as the catalogue
  schema::Value value;
  Reference reference;  ///< for ReadingStatus::reference
  Span text;            ///< the value as the control reads it: the token, or the whole of a free string
  Span trouble;         ///< text after a symbol or in a string that was meant as a comment (AX1009)
  schema::Slot slot{};  ///< where known()
  NameStatus name_status = NameStatus::unknown;
  ReadingStatus status = ReadingStatus::not_judged;
  schema::NumberStatus number = schema::NumberStatus::good;
  bool name_folded = false;    ///< the name fits only after case folding (AX1010)
  bool symbol_folded = false;  ///< the symbol fits only after case folding (AX1010)
  bool quoted = false;         ///< the text is in quotes

  [[nodiscard]] bool known() const { return name_status == NameStatus::found; }
  /// The line gives its parameter a value, directly or by reference.
  [[nodiscard]] bool usable() const {
    return known() && (status == ReadingStatus::value || status == ReadingStatus::reference);
  }
  /// The row is known, even where the index is wrong.
  [[nodiscard]] bool row_known() const { return row != nullptr; }
};

/// Fills in the value of `line_value`; its name is looked up already, `text` is the value as written. Texts
/// that are not written in UTF-8 are kept in `transcoded`.
void judge(SourceText const& source, grammar::Assignment const& assignment, LineValue& line_value,
           std::forward_list<std::string>& transcoded);

}  // namespace axisc::validator
