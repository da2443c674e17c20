// The known names taken apart, so that a mistyped one is compared with few of them. The tables of the
// built-in catalogue are made while building.
#pragma once

#include "schema/catalogue.hpp"
#include "schema/letters.hpp"
#include "schema/text_places.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::schema {

/// Numbers of names and parts that belong to one thing each: those of thing i are from starts[i] to starts[i
/// + 1].
struct Groups {
  std::span<std::uint32_t const> starts;
  std::span<std::uint32_t const> numbers;

  [[nodiscard]] std::span<std::uint32_t const> operator[](std::size_t i) const {
    return numbers.subspan(starts[i], starts[i + 1] - starts[i]);
  }
  [[nodiscard]] std::size_t size() const { return starts.size() - 1; }
};

/// The index of a name is that of its row. A part is the text between two dots; a family is the text before
/// the last part, with its dot.
struct Vocabulary {
  std::span<Parameter const> rows;
  std::span<std::string_view const> names;   ///< without brackets
  Groups names_of_size;                      ///< of each number of bytes
  std::span<Letters const> letters_by_size;  ///< of the names, in the order of names_of_size.numbers
  /// Likewise the odd letters, with room after the last one, so that letters_at_once may be read from every
  /// name on.
  std::span<OddLetters const> odd_letters_by_size;
  std::span<std::string_view const> parts;  ///< each different one
  TextPlaces places_of_parts;
  Groups parts_of;                             ///< of each name
  Groups names_ending_in;                      ///< each part
  std::span<std::string_view const> families;  ///< each different one
  TextPlaces places_of_families;
  Groups names_of_family;
  std::span<Letters const> letters_by_family;  ///< of the last parts, in the order of names_of_family.numbers
};

/// The tables of a Vocabulary that is not built in.
struct VocabularyTables {
  struct OwnGroups {
    std::vector<std::uint32_t> starts;
    std::vector<std::uint32_t> numbers;
    [[nodiscard]] Groups view() const { return {.starts = starts, .numbers = numbers}; }
  };

  std::vector<std::string> names;
  std::vector<std::string_view> name_views;  ///< of `names`
  OwnGroups names_of_size;
  std::vector<Letters> letters_by_size;
  std::vector<OddLetters> odd_letters_by_size;
  std::vector<std::string_view> parts;  ///< pieces of `names`
  std::vector<std::uint32_t> places_of_parts;
  OwnGroups parts_of;
  OwnGroups names_ending_in;
  std::vector<std::string_view> families;  ///< pieces of `names`
  std::vector<std::uint32_t> places_of_families;
  OwnGroups names_of_family;
  std::vector<Letters> letters_by_family;

  /// `names` as patterns: `filter[].order`.
  explicit VocabularyTables(std::vector<std::string> const& patterns);
  VocabularyTables(VocabularyTables const&) = delete;
  VocabularyTables& operator=(VocabularyTables const&) = delete;

  [[nodiscard]] Vocabulary view(std::span<Parameter const> rows) const;
};

[[nodiscard]] Vocabulary const& built_in_vocabulary();

/// Names of `vocabulary` that a mistyped one may have meant, see Catalogue::suggest_names.
[[nodiscard]] NameSuggestions suggest_names(Vocabulary const& vocabulary, std::string_view name);

}  // namespace axisc::schema
