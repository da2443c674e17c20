// The classes of 64 bytes without vectors: one byte after the other, by a table.
#pragma once

#include <cstdint>

namespace axisc::grammar::AXISC_LEVEL {

enum Class : std::uint8_t {
  a_usual,
  an_unusual,
  a_line_feed,
  a_carriage_return,
  a_blank,
  a_letter,
  a_digit,
  a_point,
  an_opening,
  a_closing,
  a_mark,
  class_count
};

struct Classes {
  constexpr Classes() {
    for (unsigned byte = 0; byte < 256; ++byte) of[byte] = class_of(byte);
  }
  static constexpr bool is_between(unsigned byte, unsigned first, unsigned last) {
    return first <= byte && byte <= last;
  }
  static constexpr Class class_of(unsigned byte) {
    if (byte == '\n') return a_line_feed;
    if (byte == '\r') return a_carriage_return;
    if (byte == ' ' || byte == '\t') return a_blank;
    if (byte < ' ' || byte > '~') return an_unusual;
    if (is_between(byte, '0', '9')) return a_digit;
    if (is_between(byte | 0x20U, 'a', 'z') || byte == '_') return a_letter;
    if (byte == '.') return a_point;
    if (byte == '[') return an_opening;
    if (byte == ']') return a_closing;
    return byte == '"' || byte == '(' ? a_mark : a_usual;
  }
  Class of[256] = {};
};

inline constexpr Classes classes{};

/// What TextBlock tells, see there.
class TextBlock {
 public:
  explicit TextBlock(char const* bytes) {
    for (unsigned place = 0; place < 64; ++place) {
      masks_[classes.of[static_cast<unsigned char>(bytes[place])]] |= std::uint64_t{1} << place;
    }
  }

  [[nodiscard]] std::uint64_t line_feed() const { return masks_[a_line_feed]; }
  [[nodiscard]] std::uint64_t carriage_return() const { return masks_[a_carriage_return]; }
  [[nodiscard]] std::uint64_t blank() const { return masks_[a_blank]; }
  [[nodiscard]] std::uint64_t letter() const { return masks_[a_letter]; }
  [[nodiscard]] std::uint64_t digit() const { return masks_[a_digit]; }
  [[nodiscard]] std::uint64_t point() const { return masks_[a_point]; }
  [[nodiscard]] std::uint64_t opening() const { return masks_[an_opening]; }
  [[nodiscard]] std::uint64_t closing() const { return masks_[a_closing]; }
  [[nodiscard]] std::uint64_t mark() const { return masks_[a_mark]; }
  [[nodiscard]] std::uint64_t unusual() const {
    return masks_[an_unusual] | masks_[a_line_feed] | masks_[a_carriage_return];
  }

 private:
  std::uint64_t masks_[class_count] = {};
};

}  // namespace axisc::grammar::AXISC_LEVEL
