// The hash of the perfect hash table over all concrete names; the generator and the look-up must agree on it.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace axisc::schema {

/// Eight bytes, the first one lowest, on every host.
constexpr std::uint64_t word_at(char const* bytes) {
  std::uint64_t word = 0;
  if (!std::is_constant_evaluated() && std::endian::native == std::endian::little) {
    std::memcpy(&word, bytes, sizeof word);
    return word;
  }
  for (std::size_t i = 0; i < sizeof word; ++i) {
    word |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return word;
}

/// The same of at most eight bytes, as if zeros stood behind them.
constexpr std::uint64_t word_of(std::string_view text) {
  std::array<char, sizeof(std::uint64_t)> bytes{};
  std::copy(text.begin(), text.end(), bytes.begin());
  return word_at(bytes.data());
}

/// The first and the last 24 bytes of a name, which may overlap, and of the few names that are longer what is between: how
/// many bytes a name has differs from line to line, so a loop over all of them would end where no processor expects it. The
/// bytes are combined by value, so every host computes the same hash. (Inline, with its constants, in the loop over names.)
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
    hash += word_at(first + std::min<std::size_t>(8, size - 8)) * 0x94D049BB133111EB;
    hash += word_at(first + std::min<std::size_t>(16, size - 8)) * 0xD6E8FEB86659FD93;
    hash += word_at(last - std::min<std::size_t>(16, size - 8)) * 0xFF51AFD7ED558CCD;
    hash += word_at(last - std::min<std::size_t>(8, size - 8)) * 0xC4CEB9FE1A85EC53;
    hash += word_at(last) * 0xA0761D6478BD642F;
    for (std::size_t at = 24; at + 24 < size; at += 8) hash = (hash ^ word_at(first + at)) * multiplier;
  }
  // Sums carry upwards only.
  hash = (hash ^ hash >> 32U) * multiplier;
  return hash ^ hash >> 32U;
}

/// Whether `size` bytes are the same, sixteen at a time: names are too short for a call to pay, and their sizes differ too much
/// for a loop.
[[gnu::always_inline]] constexpr bool same_bytes(char const* a, char const* b, std::size_t size) {
  constexpr std::size_t step = 16;
  if (size < step) return std::equal(a, a + size, b);
  std::uint64_t difference = 0;
  auto const compare = [&](std::size_t at) {
    std::size_t const place = std::min(at, size - step);
    difference |= word_at(a + place) ^ word_at(b + place);
    difference |= word_at(a + place + 8) ^ word_at(b + place + 8);
  };
  compare(0);
  compare(step);
  compare(2 * step);
  for (std::size_t at = 3 * step; at < size; at += step) compare(at);
  return difference == 0;
}

constexpr bool same_bytes(std::string_view a, std::string_view b) {
  return a.size() == b.size() && same_bytes(a.data(), b.data(), a.size());
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
