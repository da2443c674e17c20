// What the assignments of one list mean, judged line by line with the catalogue: before any other line is
// looked at.
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

/// A reference as it stands in a list: P-AXIS-00212.1.
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
  Span trouble;         ///< text behind a symbol or in a string that was meant as a comment (AX1009)
  schema::Slot slot{};  ///< where known()
  NameStatus name_status = NameStatus::unknown;
  ReadingStatus status = ReadingStatus::not_judged;
  schema::NumberStatus number = schema::NumberStatus::good;
  bool name_folded = false;    ///< the name fits only after case folding (AX1010)
  bool symbol_folded = false;  ///< the same of a symbol
  bool quoted = false;         ///< the text stands in quotes

  [[nodiscard]] bool known() const { return name_status == NameStatus::found; }
  /// The line gives its parameter a value, directly or by reference.
  [[nodiscard]] bool usable() const {
    return known() && (status == ReadingStatus::value || status == ReadingStatus::reference);
  }
  /// The row is known, even where the index is wrong.
  [[nodiscard]] bool row_known() const { return row != nullptr; }
};

/// What nearly all lines say: they give a known parameter a value and are beyond doubt.
struct BriefReading {
  /// For `text`, which else is the number of a symbol of the row, counted from 1: none, the value as the list writes it.
  static constexpr std::uint8_t no_text = 0;
  static constexpr std::uint8_t own_text = 255;

  double number = 0;
  std::uint32_t other =
      0;  ///< 0, or where more has to be said: its number among the other readings, from 1, which say all
  schema::Slot slot{};
  std::uint8_t text = no_text;
};
static_assert(sizeof(BriefReading) == 16);

/// The readings of one list, one for each assignment and in the same order. They look into the source, the assignments and the
/// catalogue, which live longer.
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
  /// The same of an assignment that was looked at more closely, as all doubtful ones were.
  [[nodiscard]] Reading const& closer(std::size_t assignment) const {
    assert(brief_[assignment].other != 0);
    return others_[brief_[assignment].other - 1];
  }
  /// The parameter of an assignment, where it is known.
  [[nodiscard]] std::optional<schema::Slot> slot(std::size_t assignment) const;

  /// The last assignment of a parameter, counted from 1; 0 where there is none. Only a list that was read has them.
  [[nodiscard]] std::uint32_t last_of(schema::Slot slot) const {
    assert(static_cast<std::size_t>(slot) < last_of_slot_.size());
    return last_of_slot_[static_cast<std::size_t>(slot)];
  }

  /// The readings that a check of single lines may object to: everything but a value (or a reference) of a known name,
  /// spelled right, within the parameter's own numbers, with nothing but a comment behind it. Nearly all lines of nearly
  /// all lists are beyond doubt, and no check looks at them again.
  [[nodiscard]] std::span<std::uint32_t const> doubtful() const { return doubtful_; }

  /// Assignments of known parameters whose value does not stand in their line: references, and what cannot be used.
  [[nodiscard]] std::span<std::uint32_t const> without_value() const { return without_value_; }

  /// Several lines name the same parameter.
  [[nodiscard]] bool has_repetitions() const { return has_repetitions_; }

  /// "P-" stands in the list, so that a line may name the number of a parameter.
  [[nodiscard]] bool may_name_numbers() const { return may_name_numbers_; }

  /// What may be meant by the unknown name of an assignment, best first.
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
  std::vector<Suggested> suggested_;  ///< in the order of the assignments
  std::forward_list<std::string>
      transcoded_;  ///< texts with characters that the source writes otherwise than UTF-8
  bool has_repetitions_ = false;
  bool may_name_numbers_ = false;
};

/// A list as it is written, and what each of its assignments means. The readings look into the tree: it may be moved, and
/// a copy of it is no substitute.
struct ReadList {
  grammar::AxisList tree;
  Readings readings;
};

/// Reads a list. Lines that give a parameter of the catalogue a plain value, or another one that looks simple, are read without
/// the grammar; the result is that of judge_list(). Cost: one look-up and one conversion per line; suggestions are made for
/// the first thousand unknown names only.
[[nodiscard]] ReadList read_list(SourceText const& source, schema::Catalogue const& catalogue = {});

/// The list as the grammar reads it, line by line, whatever it means.
[[nodiscard]] grammar::AxisList parse_list(SourceText const& source);
/// What the assignments of a list mean that parse_list() has read. Cost: twice to three times that of read_list(), together.
[[nodiscard]] ReadList judge_list(SourceText const& source, grammar::AxisList tree,
                                  schema::Catalogue const& catalogue = {});

/// A line that was meant for a parameter and does not set it: a broken line, a mistyped name. What the
/// parameter is meant to be is unknown then, so rules that need it have to stay silent.
struct LostAssignment {
  schema::Slot slot{};
  Span name;
  std::uint32_t line = 0;
  bool guessed =
      false;  ///< the name had to be guessed: counts only where the list does not set the parameter
};
[[nodiscard]] std::vector<LostAssignment> lost_assignments(SourceText const& source,
                                                           grammar::AxisList const& list,
                                                           Readings const& readings,
                                                           schema::Catalogue const& catalogue = {});

/// The families that become part of an image: `filter`, `filter_fir`, `vib_guard`, `lr_param.add_interface`,
/// `lr_param.improved_position_control`. `name` may be misspelt behind its family.
[[nodiscard]] bool is_compiled_family(std::string_view name);

}  // namespace axisc::validator
