#include "runtime/format/crc32c.hpp"

#include "runtime/little_endian.hpp"

#if defined(__GNUC__) && defined(__x86_64__)
#include <cpuid.h>
#elif defined(__GNUC__) && defined(__ARM_FEATURE_CRC32)
#include <arm_acle.h>
#endif

namespace {

using axisc::runtime::load_u32;

constexpr uint32_t reflected_polynomial = 0x82F63B78U;
constexpr size_t slices = 8;

// remainder[0][v] is the remainder of the byte v; remainder[s][v] the one of v followed by s zero bytes.
struct Table {
  uint32_t remainder[slices][256];
};

constexpr Table make_table() {
  Table table{};
  for (uint32_t value = 0; value < 256; ++value) {
    uint32_t crc = value;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) * reflected_polynomial);
    table.remainder[0][value] = crc;
  }
  for (size_t slice = 1; slice < slices; ++slice) {
    for (size_t value = 0; value < 256; ++value) {
      uint32_t const crc = table.remainder[slice - 1][value];
      table.remainder[slice][value] = (crc >> 8U) ^ table.remainder[0][crc & 0xFFU];
    }
  }
  return table;
}

constexpr Table table = make_table();

/// Slicing by 8: the remainders of eight bytes, each looked up with the zeros that follow it, add up.
uint32_t add_bytes(uint8_t const* next, size_t size, uint32_t crc) {
  for (; size >= slices; size -= slices, next += slices) {
    crc ^= load_u32(next);
    crc = table.remainder[7][crc & 0xFFU] ^ table.remainder[6][(crc >> 8U) & 0xFFU] ^
          table.remainder[5][(crc >> 16U) & 0xFFU] ^ table.remainder[4][crc >> 24U] ^
          table.remainder[3][next[4]] ^ table.remainder[2][next[5]] ^ table.remainder[1][next[6]] ^
          table.remainder[0][next[7]];
  }
  for (; size > 0; --size, ++next) crc = (crc >> 8U) ^ table.remainder[0][(crc ^ *next) & 0xFFU];
  return crc;
}

// Processors with an instruction for this very polynomial: eight bytes at a time, as many as are whole.
#if defined(__GNUC__) && defined(__x86_64__)

/// Asking the processor costs more than a table look-up for a few hundred bytes.
constexpr size_t least_size = 1024;

bool has_instruction() {
  uint32_t a = 0;
  uint32_t b = 0;
  uint32_t c = 0;
  uint32_t d = 0;
  return __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_SSE4_2) != 0;
}

__attribute__((target("sse4.2"))) uint32_t add_words(uint8_t const* next, size_t words, uint32_t crc) {
  uint64_t wide = crc;
  for (; words > 0; --words, next += 8) {
    uint64_t word = 0;
    __builtin_memcpy(&word, next, sizeof word);
    wide = __builtin_ia32_crc32di(wide, word);
  }
  return static_cast<uint32_t>(wide);
}

#elif defined(__GNUC__) && defined(__ARM_FEATURE_CRC32)

constexpr size_t least_size = 8;

bool has_instruction() {
  return true;
}

uint32_t add_words(uint8_t const* next, size_t words, uint32_t crc) {
  for (; words > 0; --words, next += 8) crc = __crc32cd(crc, axisc::runtime::load_u64(next));
  return crc;
}

#else

constexpr size_t least_size = 8;

bool has_instruction() {
  return false;
}

uint32_t add_words(uint8_t const* /*next*/, size_t /*words*/, uint32_t crc) {
  return crc;
}

#endif

}  // namespace

uint32_t axim_crc32c(void const* bytes, size_t size, uint32_t before) noexcept {
  auto const* next = static_cast<uint8_t const*>(bytes);
  uint32_t crc = ~before;
  if (size >= least_size && has_instruction()) {
    size_t const words = size / 8;
    crc = add_words(next, words, crc);
    next += words * 8;
    size -= words * 8;
  }
  return ~add_bytes(next, size, crc);
}
