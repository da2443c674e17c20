// The known names taken apart, so that a mistyped one is compared with few of them. The tables of the built-in catalogue
// are made while building.
#pragma once

#include "schema/catalogue.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::schema {

/// Which letters a text has, and which at least twice: one bit each. Letters that share a bit make it less telling, not
/// wrong.
using Letters = std::uint64_t;
[[nodiscard]] Letters letters_of(std::string_view text);

/// True if no edit_distance() of texts with these letters is within `limit`: a slip adds or takes away one letter at most.
[[nodiscard]] inline bool certainly_beyond(Letters a, Letters b, std::size_t limit) {
  Letters only_a = a & ~b;
  Letters only_b = b & ~a;
  for (; limit > 0; --limit) {
    only_a &= only_a - 1;
    only_b &= only_b - 1;
  }
  return (only_a | only_b) != 0;
}

/// Numbers of names and parts that belong to one thing each: those of thing i stand from starts[i] to starts[i + 1].
struct Groups {
  std::span<std::uint32_t const> starts;
  std::span<std::uint32_t const> numbers;

  [[nodiscard]] std::span<std::uint32_t const> operator[](std::size_t i) const {
    return numbers.subspan(starts[i], starts[i + 1] - starts[i]);
  }
  [[nodiscard]] std::size_t size() const { return starts.size() - 1; }
};

/// The index of a name is that of its row. A part is what stands between two dots.
struct Vocabulary {
  std::span<Parameter const> rows;
  std::span<std::string_view const> names;    ///< without brackets
  std::span<std::uint32_t const> alphabetic;  ///< the names in this order
  Groups names_of_size;                       ///< of each number of bytes
  std::span<Letters const> letters_by_size;   ///< of the names, in the order of names_of_size.numbers
  std::span<std::string_view const> parts;    ///< each different one, in alphabetic order
  std::span<Letters const> letters_of_parts;
  Groups parts_of;         ///< of each name
  Groups names_ending_in;  ///< each part
};

/// What a Vocabulary shows, where it is not built in.
struct VocabularyTables {
  struct OwnGroups {
    std::vector<std::uint32_t> starts;
    std::vector<std::uint32_t> numbers;
    [[nodiscard]] Groups view() const { return {.starts = starts, .numbers = numbers}; }
  };

  std::vector<std::string> names;
  std::vector<std::string_view> name_views;  ///< of `names`
  std::vector<std::uint32_t> alphabetic;
  OwnGroups names_of_size;
  std::vector<Letters> letters_by_size;
  std::vector<std::string_view> parts;  ///< pieces of `names`
  std::vector<Letters> letters_of_parts;
  OwnGroups parts_of;
  OwnGroups names_ending_in;

  /// `names` as patterns: `filter[].order`.
  explicit VocabularyTables(std::vector<std::string> const& patterns);
  VocabularyTables(VocabularyTables const&) = delete;
  VocabularyTables& operator=(VocabularyTables const&) = delete;

  [[nodiscard]] Vocabulary view(std::span<Parameter const> rows) const;
};

[[nodiscard]] Vocabulary const& built_in_vocabulary();

/// Names of `vocabulary` that a mistyped one may have meant, see Catalogue::suggest_names.
[[nodiscard]] std::vector<std::string> suggest_names(Vocabulary const& vocabulary, std::string_view name);

}  // namespace axisc::schema
