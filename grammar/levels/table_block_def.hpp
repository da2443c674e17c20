// The classes of 64 bytes without vectors: one byte after the other, by a table.
#pragma once

#include <cstdint>

namespace axisc::grammar::AXISC_LEVEL {

enum Class : std::uint8_t {
  a_usual,
  an_unusual,
  a_line_feed,
  a_carriage_return,
  a_space,
  a_tab,
  a_letter_p,
  a_dash,
  class_count
};

struct Classes {
  constexpr Classes() {
    for (unsigned byte = 0; byte < 256; ++byte) of[byte] = class_of(byte);
  }
  static constexpr Class class_of(unsigned byte) {
    if (byte == '\n') return a_line_feed;
    if (byte == '\r') return a_carriage_return;
    if (byte == ' ') return a_space;
    if (byte == '\t') return a_tab;
    if (byte == 'P') return a_letter_p;
    if (byte == '-') return a_dash;
    return byte < ' ' || byte > '~' || byte == ':' ? an_unusual : a_usual;
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
  [[nodiscard]] std::uint64_t letter_p() const { return masks_[a_letter_p]; }
  [[nodiscard]] std::uint64_t dash() const { return masks_[a_dash]; }
  [[nodiscard]] std::uint64_t blank() const { return masks_[a_space] | masks_[a_tab]; }
  [[nodiscard]] std::uint64_t content() const { return ~blank(); }
  /// Also tabs and line ends, as the vectors tell it.
  [[nodiscard]] std::uint64_t unusual() const {
    return masks_[an_unusual] | masks_[a_tab] | masks_[a_line_feed] | masks_[a_carriage_return];
  }

 private:
  std::uint64_t masks_[class_count] = {};
};

}  // namespace axisc::grammar::AXISC_LEVEL
