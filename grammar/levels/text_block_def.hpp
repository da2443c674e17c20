// 64 bytes of a list at a glance: which of them belong to a class, as one bit each, bit 0 for the first.
//
// A token's end is then found by counting zeros instead of looking at one byte after the other. This and the other _def
// headers are compiled once for each level, into a namespace of its own (AXISC_LEVEL). They use no inline function that
// another source could use too: of two equal ones a linker keeps one, and it might be the one that this processor cannot
// execute.
#pragma once

#include <cstdint>

#if defined(__AVX2__)
#include "grammar/levels/bytes_avx2_def.hpp"
#elif defined(__SSE2__)
#include "grammar/levels/bytes_sse2_def.hpp"
#else
#include "grammar/levels/table_block_def.hpp"
#endif

namespace axisc::grammar::AXISC_LEVEL {

using Bits = std::uint64_t;

#if defined(__SSE2__)

/// A class is computed when somebody asks for it.
class TextBlock {
 public:
  /// Reads 64 bytes.
  explicit TextBlock(char const* bytes) {
    for (unsigned i = 0; i < count; ++i) vectors_[i] = load(bytes + i * sizeof(Vector));
  }

  [[nodiscard]] Bits line_feed() const {
    return bits([](Vector bytes) { return equal(bytes, '\n'); });
  }
  [[nodiscard]] Bits carriage_return() const {
    return bits([](Vector bytes) { return equal(bytes, '\r'); });
  }
  [[nodiscard]] Bits letter_p() const {
    return bits([](Vector bytes) { return equal(bytes, 'P'); });
  }
  [[nodiscard]] Bits dash() const {
    return bits([](Vector bytes) { return equal(bytes, '-'); });
  }
  /// Space, tab.
  [[nodiscard]] Bits blank() const {
    return bits([](Vector bytes) { return either(equal(bytes, ' '), equal(bytes, '\t')); });
  }
  /// Neither space nor tab, where no other control character stands and no byte above 0x7F.
  [[nodiscard]] Bits content() const {
    return bits([](Vector bytes) { return greater(bytes, ' '); });
  }
  /// Control characters, also tabs and line ends, everything above 0x7E, and the colon.
  [[nodiscard]] Bits unusual() const {
    return ~bits([](Vector bytes) { return except(greater(plus(bytes, 1), ' '), equal(bytes, ':')); });
  }

 private:
  static constexpr unsigned count = 64 / sizeof(Vector);

  template <typename Classify>
  [[nodiscard]] Bits bits(Classify classify) const {
    Bits all = 0;
    for (unsigned i = 0; i < count; ++i) all |= bits_of(classify(vectors_[i])) << (i * sizeof(Vector));
    return all;
  }

  Vector vectors_[count];
};

#endif

}  // namespace axisc::grammar::AXISC_LEVEL
