// Places in a source: byte offsets internally, lines and columns for readers.
#pragma once

#include <compare>
#include <cstdint>

namespace axisc {

// NOLINT below: clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.

/// Half-open range of byte offsets into one source text. An empty span is a place between two bytes.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  [[nodiscard]] constexpr bool empty() const { return begin == end; }
  [[nodiscard]] constexpr std::uint32_t size() const { return end - begin; }
  friend constexpr auto operator<=>(Span const&, Span const&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Line and column, both counted from 1; columns count Unicode code points, so a tab or an umlaut is one
/// column.
struct Position {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  friend constexpr auto operator<=>(Position const&,
                                    Position const&) = default;  // NOLINT(modernize-use-nullptr)
};

}  // namespace axisc
