// The processor's control word for floating-point numbers, and words that a caller may have set.
#pragma once

#include <cstdint>
#include <vector>

namespace axisc::test {

#if defined(__x86_64__)

#define AXISC_TEST_CONTROL_WORD 1
using ControlWord = std::uint32_t;

inline ControlWord read_control_word() {
  return __builtin_ia32_stmxcsr();
}
inline void write_control_word(ControlWord word) {
  __builtin_ia32_ldmxcsr(word);
}
/// Exceptions that happened since they were cleared stand in the same word.
inline ControlWord without_flags(ControlWord word) {
  return word & ~ControlWord{0x3F};
}
inline std::uint32_t exception_flags() {
  return read_control_word() & 0x3FU;
}
/// Inexact, which nearly every computation is.
inline constexpr std::uint32_t inexact_flag = 0x20;
/// From here on subnormal operands and results raise a flag.
inline void begin_watching_subnormals() {
  write_control_word(0x1F80);
}
inline bool seen_subnormals() {
  return (exception_flags() & 0x12U) != 0;
}
inline constexpr bool exceptions_are_restored = true;
/// Start-up's word; the four directions of rounding; one of the two switches for subnormal numbers; both, as
/// the step sets them; exceptions that trap (none of the calls raises one where the caller's word holds).
inline std::vector<ControlWord> callers_control_words() {
  return {0x1F80, 0x3F80, 0x5F80,          0x7F80,           0x9F80, 0x1FC0,
          0x9FC0, 0xFFC0, 0x1F80 & ~0x80U, 0x1F80 & ~0x200U, 0};
}

#elif defined(__aarch64__)

#define AXISC_TEST_CONTROL_WORD 1
using ControlWord = std::uint64_t;

inline ControlWord read_control_word() {
  ControlWord word = 0;
  __asm__ volatile("mrs %0, fpcr" : "=r"(word)::"memory");
  return word;
}
inline void write_control_word(ControlWord word) {
  __asm__ volatile("msr fpcr, %0" ::"r"(word) : "memory");
}
/// Exceptions stand in a word of their own.
inline ControlWord without_flags(ControlWord word) {
  return word;
}
inline std::uint32_t exception_flags() {
  std::uint64_t word = 0;
  __asm__ volatile("mrs %0, fpsr" : "=r"(word)::"memory");
  return static_cast<std::uint32_t>(word) & 0x9FU;
}
inline constexpr std::uint32_t inexact_flag = 0x10;
/// From here on subnormal operands and results raise a flag: only those that are flushed to zero do.
inline void begin_watching_subnormals() {
  write_control_word(ControlWord{1} << 24U);
  std::uint64_t const none = 0;
  __asm__ volatile("msr fpsr, %0" ::"r"(none) : "memory");
}
inline bool seen_subnormals() {
  return (exception_flags() & 0x88U) != 0;
}
inline constexpr bool exceptions_are_restored = false;
/// Start-up's word, the four directions of rounding, flush to zero, default NaN.
inline std::vector<ControlWord> callers_control_words() {
  constexpr ControlWord one = 1;
  return {0, one << 22U, one << 23U, 3 * one << 22U, one << 24U, one << 25U};
}

#else

/// No such word, or one without a switch for subnormal numbers.
using ControlWord = std::uint32_t;
inline ControlWord read_control_word() {
  return 0;
}
inline void write_control_word(ControlWord) {}
inline ControlWord without_flags(ControlWord word) {
  return word;
}
inline std::vector<ControlWord> callers_control_words() {
  return {0};
}

#endif

}  // namespace axisc::test
