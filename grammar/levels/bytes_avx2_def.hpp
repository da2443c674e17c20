// 32 bytes in a vector: AVX2.
#pragma once

#include <cstdint>
#include <immintrin.h>

namespace axisc::grammar::AXISC_LEVEL {

using Vector = __m256i;
using Class = __m256i;  ///< of the bytes that belong to it all bits are set

inline Vector load(char const* bytes) {
  return _mm256_loadu_si256(reinterpret_cast<Vector const*>(bytes));  // NOLINT: how vectors are loaded
}
inline Vector in_small_letters(Vector bytes) {
  return _mm256_or_si256(bytes, _mm256_set1_epi8(0x20));
}
inline Class equal(Vector bytes, char byte) {
  return _mm256_cmpeq_epi8(bytes, _mm256_set1_epi8(byte));
}
/// Bytes above 0x7F are less than all others.
inline Class less(Vector bytes, char byte) {
  return _mm256_cmpgt_epi8(_mm256_set1_epi8(byte), bytes);
}
inline Class either(Class a, Class b) {
  return _mm256_or_si256(a, b);
}
inline Class between(Vector bytes, char first, char last) {
  return _mm256_andnot_si256(less(bytes, first), less(bytes, static_cast<char>(last + 1)));
}
inline std::uint64_t bits_of(Class a) {
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(a));
}

}  // namespace axisc::grammar::AXISC_LEVEL
