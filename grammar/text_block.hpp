// 64 bytes of a list at a glance: which of them belong to a class, as one bit each, bit 0 for the first. A
// token's end is then found by counting zeros instead of looking at one byte after the other.
//
// Bytes are compared sixteen at a time, in vectors that compilers make of whatever a processor has.
#pragma once

#include "grammar/lexical.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace axisc::grammar {

using Bits = std::uint64_t;

class TextBlock {
 public:
  static constexpr std::uint32_t size = 64;

  /// Reads 65 bytes: which class a byte is of may depend on the next one.
  explicit TextBlock(char const* bytes) {
    for (unsigned i = 0; i < count; ++i) {
      bytes_[i] = load(bytes + i * sizeof(Bytes));
      next_[i] = load(bytes + i * sizeof(Bytes) + 1);
    }
  }

  struct Layout {
    Bits line_feeds = 0;
    Bits content = 0;  ///< neither blanks nor line ends, outside of unusual bytes
  };
  [[nodiscard]] Layout layout() const {
    Words const line_feeds = gathered([this](unsigned i) { return equal(bytes_[i], lexical::line_feed); });
    Words const content = gathered([this](unsigned i) { return greater(bytes_[i], ' '); });
    Words const both = transposed(Words{line_feeds[0], content[0]} | Words{line_feeds[1], content[1]} << 1U);
    return {.line_feeds = both[0], .content = both[1]};
  }

  /// The bytes that the grammar has to look at: control characters but tabs and line ends, everything above
  /// 0x7E, and the mark of a directive.
  [[nodiscard]] Bits unusual() const {
    Words const all = gathered([this](unsigned i) { return unusual(i); });
    return transposed(Words{all[0], 0} | Words{all[1], 0} << 1U)[0];
  }
  [[nodiscard]] bool has_unusual() const {
    return any([this](unsigned i) { return unusual(i); });
  }

  /// The number of a parameter may begin in this block.
  [[nodiscard]] bool may_name_numbers() const {
    return any([this](unsigned i) {
      constexpr std::string_view prefix = lexical::parameter_number_prefix;
      static_assert(prefix.size() == 2);
      return equal(bytes_[i], prefix[0]) & equal(next_[i], prefix[1]);
    });
  }

 private:
  using Bytes [[gnu::vector_size(16)]] = signed char;
  using Words [[gnu::vector_size(16)]] = std::uint64_t;
  static constexpr unsigned count = size / sizeof(Bytes);

  static Bytes load(char const* bytes) {
    Bytes vector;
    std::memcpy(&vector, bytes, sizeof vector);
    return vector;
  }
  static Bytes every(char byte) { return Bytes{} + static_cast<signed char>(byte); }
  /// All bits of a byte or none.
  static Bytes equal(Bytes bytes, char byte) { return std::bit_cast<Bytes>(bytes == every(byte)); }
  static Bytes greater(Bytes bytes, char byte) { return std::bit_cast<Bytes>(bytes > every(byte)); }

  [[nodiscard]] Bytes unusual(unsigned i) const {
    Bytes const printable = greater(bytes_[i], ' ' - 1) & ~equal(bytes_[i], '\x7F');
    Bytes const blank = equal(bytes_[i], '\t');
    Bytes const line_end = equal(bytes_[i], lexical::line_feed) |
                           (equal(bytes_[i], lexical::carriage_return) & equal(next_[i], lexical::line_feed));
    return ~(printable | blank | line_end) | equal(bytes_[i], lexical::directive_mark);
  }

  template <typename Classify>
  static bool any(Classify classify) {
    Bytes all{};
    for (unsigned i = 0; i < count; ++i) all |= classify(i);
    auto const words = std::bit_cast<Words>(all);
    return (words[0] | words[1]) != 0;
  }

  /// Bit 2i of byte j of the first word for byte j of vector i, of the second one for byte 8 + j.
  template <typename Classify>
  static Words gathered(Classify classify) {
    Bytes all{};
    for (unsigned i = 0; i < count; ++i) all |= classify(i) & every(static_cast<char>(1U << (2 * i)));
    auto words = std::bit_cast<Words>(all);
    if constexpr (std::endian::native == std::endian::big) {
      words = Words{__builtin_bswap64(words[0]), __builtin_bswap64(words[1])};
    }
    return words;
  }

  /// Bit i of byte j becomes bit j of byte i: H. S. Warren, "Hacker's Delight", 7-3.
  static Words transposed(Words words) {
    auto const exchange = [&words](unsigned distance, Bits mask) {
      Words const differing = (words ^ (words >> distance)) & (Words{} + mask);
      words ^= differing ^ (differing << distance);
    };
    exchange(7, 0x00AA00AA00AA00AA);
    exchange(14, 0x0000CCCC0000CCCC);
    exchange(28, 0x00000000F0F0F0F0);
    return words;
  }

  std::array<Bytes, count> bytes_;
  std::array<Bytes, count> next_;
};

}  // namespace axisc::grammar
