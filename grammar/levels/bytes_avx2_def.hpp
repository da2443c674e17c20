// 32 bytes in a vector: AVX2.
#pragma once

#include "grammar/levels/every_byte.hpp"

#include <cstdint>
#include <immintrin.h>

namespace axisc::grammar::AXISC_LEVEL {

using Vector = __m256i;
using Class = __m256i;  ///< of the bytes that belong to it all bits are set

inline Vector load(char const* bytes) {
  return _mm256_loadu_si256(reinterpret_cast<Vector const*>(bytes));  // NOLINT: how vectors are loaded
}
inline Vector every(char byte) {
  auto const* const bytes = every_byte.of[static_cast<unsigned char>(byte)];
  return _mm256_load_si256(reinterpret_cast<Vector const*>(bytes));  // NOLINT: how vectors are loaded
}
inline Class equal(Vector bytes, char byte) {
  return _mm256_cmpeq_epi8(bytes, every(byte));
}
/// Bytes above 0x7F are not: they are less than all others.
inline Class greater(Vector bytes, char byte) {
  return _mm256_cmpgt_epi8(bytes, every(byte));
}
inline Class either(Class a, Class b) {
  return _mm256_or_si256(a, b);
}
inline Class except(Class a, Class excepted) {
  return _mm256_andnot_si256(excepted, a);
}
/// Modulo 256; `byte` is ASCII.
inline Vector plus(Vector bytes, char byte) {
  return _mm256_add_epi8(bytes, every(byte));
}
inline std::uint64_t bits_of(Class a) {
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(a));
}

}  // namespace axisc::grammar::AXISC_LEVEL
