#include "grammar/invalid_character.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace axisc::grammar {
namespace {

constexpr std::size_t block_size = sizeof(std::uint64_t);

/// False only if every byte is printable ASCII. The three terms set the top bit of a byte below 0x20, of a
/// byte above 0x7F and of the byte 0x7F; a borrow between bytes can only add alarms.
bool needs_a_look(char const* block) {
  constexpr std::uint64_t ones = 0x0101010101010101;
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, block, block_size);
  std::uint64_t const below_blank = bytes - ones * 0x20;
  std::uint64_t const delete_character = (bytes ^ (ones * 0x7F)) - ones;
  return ((below_blank | bytes | delete_character) & (ones * 0x80)) != 0;
}

bool is_undefined_in_windows_1252(unsigned char byte) {
  return byte == 0x81 || byte == 0x8D || byte == 0x8F || byte == 0x90 || byte == 0x9D;
}

/// Number of bytes of the invalid character at `position`, 0 if there is none.
std::uint32_t invalid_size(std::string_view line, std::size_t position, bool windows_1252) {
  auto const byte = static_cast<unsigned char>(line[position]);
  if (byte < 0x20) return byte == '\t' ? 0 : 1;
  if (byte < 0x7F) return 0;
  if (byte == 0x7F) return 1;
  if (windows_1252) return is_undefined_in_windows_1252(byte) ? 1 : 0;
  if (byte != 0xC2 || position + 1 == line.size()) return 0;
  auto const continuation = static_cast<unsigned char>(line[position + 1]);
  return continuation >= 0x80 && continuation < 0xA0 ? 2 : 0;
}

}  // namespace

std::optional<Span> find_invalid_character(std::string_view line, bool windows_1252) {
  std::size_t position = 0;
  while (position < line.size()) {
    // The last block may overlap the one before.
    std::size_t const block = std::min(position, line.size() - std::min(line.size(), block_size));
    if (line.size() >= block_size && !needs_a_look(line.data() + block)) {
      position = block + block_size;
      continue;
    }
    std::size_t const stop = line.size() - position < block_size ? line.size() : position + block_size;
    for (; position < stop; ++position) {
      if (auto const size = invalid_size(line, position, windows_1252); size != 0) {
        auto const begin = static_cast<std::uint32_t>(position);
        return Span{.begin = begin, .end = begin + size};
      }
    }
  }
  return std::nullopt;
}

}  // namespace axisc::grammar
