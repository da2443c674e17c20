// Text for a terminal: colours, and nothing from a file that could steer it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace axisc {

/// `text` as one line of well-formed UTF-8: control characters become their pictures (U+2400 and up), marks
/// that turn the direction of writing and bytes that cannot be decoded become U+FFFD.
[[nodiscard]] std::string printable(std::string_view text);

/// The same for one character, appended.
void append_printable(std::string& text, char32_t character);

enum class Style : std::uint8_t { error, warning, note, gutter, strong, added, removed };

/// Puts ANSI colours around words, or leaves them alone.
class Painter {
 public:
  explicit Painter(bool color) : color_(color) {}
  [[nodiscard]] std::string operator()(Style style, std::string_view text) const;

 private:
  bool color_;
};

}  // namespace axisc
