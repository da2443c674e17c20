// The hash of the perfect hash table over all concrete names; the generator and the look-up must agree on it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace axisc::schema {

/// Multiply and fold, eight bytes at a time. The bytes are combined by value, so every host computes the same hash.
constexpr std::uint64_t hash_name(std::string_view name) {
  constexpr std::uint64_t multiplier = 0x9E3779B97F4A7C15;
  std::uint64_t hash = name.size() * multiplier;
  while (!name.empty()) {
    std::size_t const size = name.size() < 8 ? name.size() : 8;
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < size; ++i) {
      word |= static_cast<std::uint64_t>(static_cast<unsigned char>(name[i])) << (8 * i);
    }
    hash = (hash ^ word) * multiplier;
    hash ^= hash >> 32U;
    name.remove_prefix(size);
  }
  return hash;
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
