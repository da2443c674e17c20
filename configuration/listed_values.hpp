// The assignments of a list of any kind as names and texts, which tell which lists, axes and channels make a
// machine.
#pragma once

#include "configuration/located_text.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace axisc::configuration {

/// One line `name value`.
struct ListedValue {
  std::string_view name;  ///< as written; looks into the source
  LocatedText value;  ///< a number or word, or all up to a comment where the value is neither; without quotes
  Place name_place;
};

/// The indices of a name, in the order of its brackets.
struct NameIndices {
  std::array<std::uint32_t, 3> index{};
  [[nodiscard]] std::uint32_t operator[](std::size_t position) const { return index.at(position); }
};

/// A number with its place: how many entries there are, or the number of an axis.
struct ListCount {
  std::uint32_t number = 0;
  Place place;
};

/// All assignments up to `Ende`, in the order of the lines; lines that the grammar refuses are left out.
/// Cost: one pass.
[[nodiscard]] std::vector<ListedValue> listed_values(SourceText const& text, SourceId source);

/// The indices of `name` where it is `pattern` with a number in each `[]` (`achs_mds[2]` of `achs_mds[]`), in
/// upper or lower case.
[[nodiscard]] std::optional<NameIndices> match_name(std::string_view name, std::string_view pattern);

/// A decimal integer; none for everything else.
[[nodiscard]] std::optional<std::uint32_t> as_number(LocatedText const& value);
[[nodiscard]] std::optional<ListCount> as_count(ListedValue const& listed);

}  // namespace axisc::configuration
