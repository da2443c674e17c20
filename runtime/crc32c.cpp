#include "runtime/format/crc32c.hpp"

#include "runtime/little_endian.hpp"

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

}  // namespace

uint32_t axim_crc32c(void const* bytes, size_t size, uint32_t before) noexcept {
  auto const* next = static_cast<uint8_t const*>(bytes);
  uint32_t crc = ~before;
  // Slicing by 8: the remainders of eight bytes, each looked up with the zeros that follow it, add up.
  for (; size >= slices; size -= slices, next += slices) {
    crc ^= load_u32(next);
    crc = table.remainder[7][crc & 0xFFU] ^ table.remainder[6][(crc >> 8U) & 0xFFU] ^
          table.remainder[5][(crc >> 16U) & 0xFFU] ^ table.remainder[4][crc >> 24U] ^
          table.remainder[3][next[4]] ^ table.remainder[2][next[5]] ^ table.remainder[1][next[6]] ^
          table.remainder[0][next[7]];
  }
  for (; size > 0; --size, ++next) crc = (crc >> 8U) ^ table.remainder[0][(crc ^ *next) & 0xFFU];
  return ~crc;
}
