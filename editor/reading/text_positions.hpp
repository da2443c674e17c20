// Positions as the protocol counts them: lines from 0, and in a line the units of an encoding.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace axisc::editor {

enum class PositionEncoding : std::uint8_t { utf8, utf16, utf32 };

struct TextPosition {
  std::size_t line = 0;
  std::size_t character = 0;
  friend constexpr auto operator<=>(TextPosition const&,
                                    TextPosition const&) = default;  // NOLINT(modernize-use-nullptr)
};

/// The byte at a position in UTF-8 text. Positions after the end of a line mean its end, those after the last
/// line the end of the text. Lines end with LF, CRLF or CR.
[[nodiscard]] std::size_t offset_of(std::string_view text, TextPosition position, PositionEncoding encoding);

/// The position of a byte.
[[nodiscard]] TextPosition position_of(std::string_view text, std::size_t offset, PositionEncoding encoding);

/// The byte after a number of units; line ends count as units.
[[nodiscard]] std::size_t offset_of_unit(std::string_view text, std::size_t unit, PositionEncoding encoding);

/// Number of units in the first `characters` characters of a line.
[[nodiscard]] std::size_t units(std::string_view line, std::size_t characters, PositionEncoding encoding);

/// The lines of a text, for many positions in it.
class TextLines {
 public:
  /// The text outlives the lines.
  TextLines(std::string_view text, PositionEncoding encoding);

  [[nodiscard]] std::size_t count() const { return begins_.size(); }
  /// Without its end.
  [[nodiscard]] std::string_view line(std::size_t line) const;
  [[nodiscard]] std::size_t begin(std::size_t line) const { return begins_[line]; }
  [[nodiscard]] std::size_t offset(TextPosition position) const;
  [[nodiscard]] TextPosition position(std::size_t offset) const;
  /// Number of units in a piece of a line.
  [[nodiscard]] std::size_t units_of(std::string_view piece) const {
    return units(piece, piece.size(), encoding_);
  }

 private:
  std::string_view text_;
  PositionEncoding encoding_;
  std::vector<std::size_t> begins_;
};

}  // namespace axisc::editor
