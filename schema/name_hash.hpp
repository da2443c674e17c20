// The hash of the perfect hash tables over names; the generator and the look-up must agree on it.
#pragma once

#include "schema/words.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace axisc::schema {

/// The first and the last 24 bytes of a name, which may overlap, and the middle of the few names that are
/// longer: the length of names differs from line to line, so processors would mispredict the end of a loop
/// over all bytes. The bytes are combined by value, so every host computes the same hash. (Inline, with its
/// constants, in the loop over names.)
///
/// A word that is among the first and among the last bytes counts with the sum of two factors, or of six. All
/// factors are 1 modulo 4, so such a sum is even but not a multiple of four: only the top bit of one byte is
/// lost, which no name has.
[[gnu::always_inline]] constexpr std::uint64_t hash_name(std::string_view name) {
  constexpr std::uint64_t multiplier = 0x9E3779B97F4A7C15;
  std::size_t const size = name.size();
  std::uint64_t hash = size * multiplier;
  if (size < 8) {
    hash ^= word_of(name);
  } else {
    char const* const first = name.data();
    char const* const last = first + size - 8;
    hash += word_at(first) * 0xBF58476D1CE4E5B9;
    hash += word_at(first + std::min<std::size_t>(8, size - 8)) * 0x94D049BB133111E9;
    hash += word_at(first + std::min<std::size_t>(16, size - 8)) * 0xD6E8FEB86659FD91;
    hash += word_at(last - std::min<std::size_t>(16, size - 8)) * 0xFF51AFD7ED558CCD;
    hash += word_at(last - std::min<std::size_t>(8, size - 8)) * 0xC4CEB9FE1A85EC51;
    hash += word_at(last) * 0xA0761D6478BD642D;
    for (std::size_t at = 24; at + 24 < size; at += 8) hash = (hash ^ word_at(first + at)) * multiplier;
  }
  // Sums carry upwards only.
  hash = (hash ^ hash >> 32U) * multiplier;
  return hash ^ hash >> 32U;
}

/// Two-level hashing (hash, displace): names fall into buckets, and every bucket has a displacement that
/// sends its names to free places of the table.
struct HashGeometry {
  std::uint32_t buckets = 0;  ///< a power of two
  std::uint32_t places = 0;   ///< a power of two
};

constexpr std::uint32_t bucket_of(std::uint64_t hash, HashGeometry geometry) {
  return static_cast<std::uint32_t>(hash >> 48U) & (geometry.buckets - 1);
}

constexpr std::uint32_t place_of(std::uint64_t hash, std::uint32_t displacement, HashGeometry geometry) {
  auto const start = static_cast<std::uint32_t>(hash);
  auto const stride = static_cast<std::uint32_t>(hash >> 24U) | 1U;
  return (start + displacement * stride) & (geometry.places - 1);
}

}  // namespace axisc::schema
