// What the assignments of one list mean, judged line by line with the catalogue, each line on its own.
#pragma once

#include "diagnostics/source_text.hpp"
#include "grammar/axis_list.hpp"
#include "schema/catalogue.hpp"
#include "schema/value.hpp"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <forward_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::validator {

enum class ReadingStatus : std::uint8_t {
  value,              ///< `value` holds what the control reads
  reference,          ///< the value of another parameter, to be looked up in the effective values
  not_judged,         ///< the name is unknown, so nothing is known about the value
  decimal_comma,      ///< AX1005
  malformed_number,   ///< AX1006, `number` says why
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

struct Reading {
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

/// The compact reading of nearly all lines: those that plainly give a known parameter a value.
struct BriefReading {
  /// Special values of `text`, otherwise the number of a symbol of the row, counted from 1.
  static constexpr std::uint8_t no_text = 0;     ///< no text
  static constexpr std::uint8_t own_text = 255;  ///< the value as written in the list

  double number = 0;
  std::uint32_t other = 0;  ///< 0, or the number (from 1) of the full Reading if this one does not suffice
  schema::Slot slot{};
  std::uint8_t text = no_text;
};
static_assert(sizeof(BriefReading) == 16);

/// The readings of one list, one for each assignment and in the same order. They refer to the source, the assignments
/// and the catalogue, which must outlive them.
class Readings {
 public:
  Readings() = default;
  Readings(Readings const&) = delete;
  Readings(Readings&&) = default;
  Readings& operator=(Readings const&) = delete;
  Readings& operator=(Readings&&) = default;
  ~Readings() = default;

  [[nodiscard]] std::size_t size() const { return brief_.size(); }
  [[nodiscard]] Reading operator[](std::size_t assignment) const;
  /// The full reading of an assignment that was judged closely, as all doubtful ones are.
  [[nodiscard]] Reading const& closer(std::size_t assignment) const {
    assert(brief_[assignment].other != 0);
    return others_[brief_[assignment].other - 1];
  }
  /// The parameter of an assignment, if it is known.
  [[nodiscard]] std::optional<schema::Slot> slot(std::size_t assignment) const;

  /// The last assignment of a parameter, counted from 1; 0 if there is none. Only available for a list that was read
  /// with read_list().
  [[nodiscard]] std::uint32_t last_of(schema::Slot slot) const {
    assert(static_cast<std::size_t>(slot) < last_of_slot_.size());
    return last_of_slot_[static_cast<std::size_t>(slot)];
  }

  /// The readings that a check of single lines may report: all except a value (or reference) of a known name, spelled
  /// correctly, within the range of the parameter, followed by nothing but a comment. Nearly all lines are beyond
  /// doubt, and no check reads them again.
  [[nodiscard]] std::span<std::uint32_t const> doubtful() const { return doubtful_; }

  /// Assignments of known parameters without a value of their own: references, and unusable values.
  [[nodiscard]] std::span<std::uint32_t const> without_value() const { return without_value_; }

  /// Several lines name the same parameter.
  [[nodiscard]] bool has_repetitions() const { return has_repetitions_; }

  /// The list contains "P-", so a line may name the number of a parameter.
  [[nodiscard]] bool may_name_numbers() const { return may_name_numbers_; }

  /// Suggestions for the unknown name of an assignment, best first.
  [[nodiscard]] std::span<std::string const> suggestions(std::size_t assignment) const;

 private:
  friend class ListReader;

  struct Suggested {
    std::uint32_t assignment = 0;
    std::vector<std::string> names;
  };

  std::string_view bytes_;  ///< of the source
  std::span<grammar::Assignment const> assignments_;
  schema::Catalogue catalogue_;
  std::vector<BriefReading> brief_;
  std::vector<Reading> others_;
  std::vector<std::uint32_t> last_of_slot_;
  std::vector<std::uint32_t> doubtful_;
  std::vector<std::uint32_t> without_value_;
  std::vector<Suggested> suggested_;           ///< in the order of the assignments
  std::forward_list<std::string> transcoded_;  ///< texts whose source encoding is not UTF-8
  bool has_repetitions_ = false;
  bool may_name_numbers_ = false;
};

/// A list as written, and what each of its assignments means. The readings refer to the tree, which may be moved but
/// not replaced by a copy.
struct ReadList {
  grammar::AxisList tree;
  Readings readings;
};

/// Reads a list. Lines that give a parameter of the catalogue a plain value, or another one that looks simple, are read
/// without the grammar; the result is that of judge_list(). Cost: one look-up and one conversion per line; suggestions
/// are made for the first thousand unknown names only.
[[nodiscard]] ReadList read_list(SourceText const& source, schema::Catalogue const& catalogue = {});

/// The list as the grammar reads it, line by line, whatever it means.
[[nodiscard]] grammar::AxisList parse_list(SourceText const& source);
/// The readings of a list that parse_list() has read. Cost: twice to three times that of read_list(), together.
[[nodiscard]] ReadList judge_list(SourceText const& source, grammar::AxisList tree,
                                  schema::Catalogue const& catalogue = {});

/// A line that was meant for a parameter but does not set it: a broken line, a mistyped name. The
/// intended value is unknown, so rules that need it report nothing.
struct LostAssignment {
  schema::Slot slot{};
  Span name;
  std::uint32_t line = 0;
  bool guessed = false;  ///< the name had to be guessed: used only if the list does not set the parameter
};
[[nodiscard]] std::vector<LostAssignment> lost_assignments(SourceText const& source,
                                                           grammar::AxisList const& list,
                                                           Readings const& readings,
                                                           schema::Catalogue const& catalogue = {});

/// The families that become part of an image: `filter`, `filter_fir`, `vib_guard`, `lr_param.add_interface`,
/// `lr_param.improved_position_control`. `name` may be misspelt after its family.
[[nodiscard]] bool is_compiled_family(std::string_view name);

}  // namespace axisc::validator
