// How alike two parts of names are: `order` and `oder`.
#pragma once

#include "schema/vocabulary.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace axisc::schema {

// What the differences between a name and a known one weigh. A slip of the pen is 1.
inline constexpr std::size_t resembling_part = 2;  ///< `fir` for `filter_fir`
inline constexpr std::size_t missing_part = 2;     ///< the part is not there at all
inline constexpr std::size_t foreign_part =
    4;  ///< another word: the parameter is known, but in another family

/// Of a word: fewer letters begin too many words.
inline constexpr std::size_t shortest_beginning = 3;

/// True if the shorter word is one or several whole words of the longer: `filter` in `filter_fir`.
[[nodiscard]] bool resembles(std::string_view a, std::string_view b);

/// What one part of a given name has to do with the known parts.
class PartComparison {
 public:
  PartComparison(Vocabulary const& vocabulary, std::string_view given);

  struct Result {
    bool agrees;                      ///< but for some slips
    std::optional<std::size_t> cost;  ///< none where nothing is alike
  };

  /// `part` is the number of a known one. Each is compared once.
  [[nodiscard]] Result with(std::size_t part);
  /// with(part) has a cost.
  [[nodiscard]] bool is_like(std::size_t part) { return may_be_like(part) && cost_of(part) != unlike; }

 private:
  // Costs that are none.
  static constexpr std::uint8_t not_compared = 255;
  static constexpr std::uint8_t unlike = 254;
  static constexpr std::uint8_t resembling = 253;

  /// By the letters alone, which rule out nearly every part.
  [[nodiscard]] bool may_be_like(std::size_t part) const {
    Letters const wanted = vocabulary_.letters_of_parts[part];
    return may_contain_one_another(letters_, wanted) || !certainly_beyond(letters_, wanted, limit_);
  }
  [[nodiscard]] std::uint8_t cost_of(std::size_t part);
  [[nodiscard]] std::uint8_t compare(std::size_t part) const;

  Vocabulary const& vocabulary_;
  std::string_view given_;
  Letters letters_;
  std::size_t limit_;
  std::vector<std::uint8_t> costs_;
};

/// Compares the parts of two names from the last one on, which is alike. None when they have too little in common.
[[nodiscard]] std::optional<std::size_t> part_distance(std::vector<PartComparison>& given,
                                                       std::span<std::uint32_t const> known);

}  // namespace axisc::schema
