// The meaning of the assignments of one list, line by line.
#pragma once

#include "validator/values/line_value.hpp"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <forward_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace axisc::validator {

/// The content of nearly all lines: they give a known parameter a value and are beyond doubt.
struct BriefReading {
  /// For `text`, which is otherwise the number of a symbol of the row, counted from 1: none, the value as the
  /// list writes it.
  static constexpr std::uint8_t no_text = 0;
  static constexpr std::uint8_t own_text = 255;

  double number = 0;
  std::uint32_t other = 0;  ///< 0, or for other lines their number among the complete line values, from 1
  std::uint16_t slot = 0;   ///< of axis parameters, which 16 bits count
  std::uint8_t text = no_text;
};
static_assert(sizeof(BriefReading) == 16);

/// The line values of one list, one for each assignment and in the same order. They look into the source, the
/// assignments and the catalogue, which must outlive them.
class LineValues {
 public:
  LineValues() = default;
  LineValues(LineValues const&) = delete;
  LineValues(LineValues&&) = default;
  LineValues& operator=(LineValues const&) = delete;
  LineValues& operator=(LineValues&&) = default;
  ~LineValues() = default;

  [[nodiscard]] std::size_t size() const { return brief_.size(); }
  [[nodiscard]] LineValue operator[](std::size_t assignment) const;
  /// The complete line value of an assignment that was looked at more closely, as all doubtful ones were.
  [[nodiscard]] LineValue const& closer(std::size_t assignment) const {
    assert(brief_[assignment].other != 0);
    return others_[brief_[assignment].other - 1];
  }
  /// The parameter of an assignment, where it is known.
  [[nodiscard]] std::optional<schema::Slot> slot(std::size_t assignment) const;

  /// The last assignment of a parameter, counted from 1; 0 where there is none. Only a list that was read has
  /// them.
  [[nodiscard]] std::uint32_t last_of(schema::Slot slot) const {
    if (catalogue_.kind() != schema::ListKind::axis) {
      auto const found = last_of_many_.find(slot);
      return found == last_of_many_.end() ? 0 : found->second;
    }
    assert(static_cast<std::size_t>(slot) < last_of_slot_.size());
    return last_of_slot_[static_cast<std::size_t>(slot)];
  }

  /// The line values that a check of single lines may object to: everything but a value (or a reference) of a
  /// known name, spelled right, within the parameter's own numbers, with nothing but a comment after it.
  /// Nearly all lines of nearly all lists are beyond doubt, and no check looks at them again.
  [[nodiscard]] std::span<std::uint32_t const> doubtful() const { return doubtful_; }

  /// Assignments of known parameters whose value is not in their line: references, and unusable values.
  [[nodiscard]] std::span<std::uint32_t const> without_value() const { return without_value_; }

  /// Several lines name the same parameter.
  [[nodiscard]] bool has_repetitions() const { return has_repetitions_; }

  /// "P-" is in the list, so that a line may name the number of a parameter.
  [[nodiscard]] bool may_name_numbers() const { return may_name_numbers_; }

  /// Possible meanings of the unknown name of an assignment.
  [[nodiscard]] schema::NameSuggestions const& suggestions(std::size_t assignment) const;

 private:
  friend class ListReader;

  struct Suggested {
    std::uint32_t assignment = 0;
    schema::NameSuggestions names;
  };

  std::string_view bytes_;  ///< of the source
  std::span<grammar::Assignment const> assignments_;
  schema::Catalogue catalogue_;
  std::vector<BriefReading> brief_;
  std::vector<LineValue> others_;
  std::vector<std::uint32_t> last_of_slot_;  ///< in axis lists
  std::unordered_map<schema::Slot, std::uint32_t>
      last_of_many_;  ///< in lists whose tables have millions of slots
  std::vector<std::uint32_t> doubtful_;
  std::vector<std::uint32_t> without_value_;
  std::vector<Suggested> suggested_;  ///< in the order of the assignments
  std::forward_list<std::string>
      transcoded_;  ///< texts with characters that the source does not write in UTF-8
  bool has_repetitions_ = false;
  bool may_name_numbers_ = false;
};

}  // namespace axisc::validator
