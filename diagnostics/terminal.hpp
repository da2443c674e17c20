// Text for a terminal: colours, and no control characters from files.
#pragma once

#include "diagnostics/ascii.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace axisc {

/// False for control characters, marks that turn the direction of writing and characters without width: a
/// reader would not see them, and a terminal would obey some.
[[nodiscard]] bool is_visible(char32_t character);
/// Every character of a UTF-8 text is visible.
[[nodiscard]] bool is_visible(std::string_view text);

/// `text` as one line of well-formed UTF-8: ASCII control characters become their pictures (U+2400 and up),
/// other invisible ones and bytes that cannot be decoded become U+FFFD. Every foreign name is printed through
/// this.
[[nodiscard]] std::string printable(std::string_view text);

/// Append printable() of a text, or of one character, to `out`.
void append_printable(std::string& shown, std::string_view text);
void append_printable(std::string& shown, char32_t character);

/// ASCII that printable() leaves as it is: neither a control character nor part of a longer one.
[[nodiscard]] constexpr bool is_plain(char byte) {
  return ascii::is_printable(byte);
}

/// Every character is plain. Cost: linear, eight bytes at a time.
[[nodiscard]] bool is_plain(std::string_view text);

enum class Style : std::uint8_t { error, warning, note, gutter, strong, added, removed };

/// Puts ANSI colours around text, if enabled.
class Painter {
 public:
  explicit Painter(bool color) : color_(color) {}
  [[nodiscard]] bool colors() const { return color_; }
  [[nodiscard]] std::string operator()(Style style, std::string_view text) const;
  /// Appends the coloured text to `out`.
  void append(std::string& out, Style style, std::string_view text) const {
    if (text.empty()) return;
    begin(out, style);
    out.append(text);
    end(out);
  }
  /// Begin and end of coloured text that is written in between.
  void begin(std::string& out, Style style) const {
    if (color_) begin_color(out, style);
  }
  void end(std::string& out) const {
    if (color_) end_color(out);
  }

 private:
  static void begin_color(std::string& out, Style style);
  static void end_color(std::string& out);

  bool color_;
};

}  // namespace axisc
