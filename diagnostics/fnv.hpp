// FNV-1a with 64 bits: equal on every system, and no protection against attacks.
#pragma once

#include <cstdint>
#include <string_view>

namespace axisc {

inline constexpr std::uint64_t fnv_basis = 0xCBF29CE484222325U;

/// The hash of what `hash` is that of, followed by `text`.
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view text, std::uint64_t hash = fnv_basis) {
  constexpr std::uint64_t prime = 0x100000001B3U;
  for (char const byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * prime;
  return hash;
}

}  // namespace axisc
