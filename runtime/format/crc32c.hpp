// CRC-32C (Castagnoli) as the image format uses it: polynomial 0x1EDC6F41, bits reflected, initial value and
// final complement 0xFFFFFFFF; the checksum of "123456789" is 0xE3069283. For the loader and for tools that
// write images.
#pragma once

#include <stddef.h>
#include <stdint.h>

/// Checksum of `size` bytes after others whose checksum is `before` (0: they are the first).
/// Cost: proportional to size.
[[nodiscard]] uint32_t axim_crc32c(void const* bytes, size_t size, uint32_t before = 0) noexcept;

/// Checksum of anything with data() and size() that consists of bytes.
template <class Bytes>
[[nodiscard]] uint32_t axim_crc32c(Bytes const& bytes) noexcept {
  static_assert(sizeof(*bytes.data()) == 1, "a checksum is over bytes");
  return axim_crc32c(bytes.data(), bytes.size());
}
