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

/// The byte after a number of units; line ends count as units.
[[nodiscard]] std::size_t offset_of_unit(std::string_view text, std::size_t unit, PositionEncoding encoding);

/// Number of units in the first `characters` characters of a line.
[[nodiscard]] std::size_t units(std::string_view line, std::size_t characters, PositionEncoding encoding);

/// The lines of a text in UTF-8. They end with LF, CRLF or CR.
class TextLines {
 public:
  /// Reads the whole text, which outlives the lines.
  TextLines(std::string_view text, PositionEncoding encoding);

  [[nodiscard]] std::size_t count() const { return begins_.size(); }
  /// Without its end.
  [[nodiscard]] std::string_view line(std::size_t line) const;
  [[nodiscard]] std::size_t begin(std::size_t line) const { return begins_[line]; }
  /// The byte at a position: the end of the line or of the text if the position is after it.
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
