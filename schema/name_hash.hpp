// The hash of the perfect hash table over all concrete names; the generator and the look-up must agree on it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace axisc::schema {

/// Up to eight bytes, the first one lowest, on every host.
constexpr std::uint64_t word_of(char const* bytes, std::size_t size) {
  std::uint64_t word = 0;
  if (size == 8 && !std::is_constant_evaluated() && std::endian::native == std::endian::little) {
    std::memcpy(&word, bytes, sizeof word);
    return word;
  }
  for (std::size_t i = 0; i < size; ++i) {
    word |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return word;
}

/// Multiply and fold, eight bytes at a time. The bytes are combined by value, so every host computes the same hash.
constexpr std::uint64_t hash_name(std::string_view name) {
  constexpr std::uint64_t multiplier = 0x9E3779B97F4A7C15;
  std::uint64_t hash = name.size() * multiplier;
  char const* at = name.data();
  std::size_t left = name.size();
  auto const fold = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * multiplier;
    hash ^= hash >> 32U;
  };
  for (; left >= 8; at += 8, left -= 8) fold(word_of(at, 8));
  if (left == 0) return hash;
  // The last eight bytes at once, of which those that were folded already drop out.
  bool const long_enough = name.size() >= 8;
  fold(long_enough ? word_of(at + left - 8, 8) >> (8 * (8 - left)) : word_of(at, left));
  return hash;
}

/// `a == b`, eight bytes at a time: names are too short for a call to pay.
constexpr bool same_bytes(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  std::size_t const size = a.size();
  if (size < 8) return word_of(a.data(), size) == word_of(b.data(), size);
  for (std::size_t at = 0; at + 8 < size; at += 8) {
    if (word_of(a.data() + at, 8) != word_of(b.data() + at, 8)) return false;
  }
  return word_of(a.data() + size - 8, 8) == word_of(b.data() + size - 8, 8);
}

/// Two-level hashing (hash, displace): names fall into buckets, and every bucket has a displacement that sends its
/// names to free places of the table.
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
