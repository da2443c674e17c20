#include "runtime/instructions.hpp"

#if defined(AXISRT_HAS_X86_64_LEVELS)
#include <cpuid.h>
#endif

namespace axisc::runtime {

namespace portable {
extern Instructions const instructions;
}
#if defined(AXISRT_HAS_X86_64_LEVELS)
namespace x86_64_v2 {
extern Instructions const instructions;
}
namespace x86_64_v3 {
extern Instructions const instructions;
}
namespace x86_64_v4 {
extern Instructions const instructions;
}
#endif
#if defined(AXISRT_HAS_NEON)
namespace neon {
extern Instructions const instructions;
}
#endif

namespace {

#if defined(AXISRT_HAS_X86_64_LEVELS)

/// Registers that the operating system saves when it switches tasks; an instruction set is of no use without.
uint64_t saved_registers() {
  uint32_t low = 0;
  uint32_t high = 0;
  __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return low | static_cast<uint64_t>(high) << 32U;
}

bool has_all(uint32_t word, uint32_t bits) {
  return (word & bits) == bits;
}

/// The highest level of which this processor has every feature. Single features are tested, never the
/// processor's model: emulators and virtual machines may lack any of them.
uint32_t best_x86_64_level() {
  constexpr uint32_t v2_ecx = bit_SSE3 | bit_SSSE3 | bit_CMPXCHG16B | bit_SSE4_1 | bit_SSE4_2 | bit_POPCNT;
  constexpr uint32_t v3_ecx = bit_FMA | bit_MOVBE | bit_OSXSAVE | bit_AVX | bit_F16C;
  constexpr uint32_t v3_ebx = bit_AVX2 | bit_BMI | bit_BMI2;
  constexpr uint32_t v4_ebx = bit_AVX512F | bit_AVX512BW | bit_AVX512CD | bit_AVX512DQ | bit_AVX512VL;
  constexpr uint32_t v3_extended_ecx = 1U << 5U;  // LZCNT
  constexpr uint32_t v2_extended_ecx = 1U << 0U;  // LAHF
  constexpr uint64_t vectors_256 = 0x06;
  constexpr uint64_t vectors_512 = 0xE6;
  uint32_t a = 0;
  uint32_t b = 0;
  uint32_t c = 0;
  uint32_t d = 0;
  if (__get_cpuid(1, &a, &b, &c, &d) == 0) return AXISRT_LEVEL_PORTABLE;
  uint32_t const features = c;
  uint32_t extended = 0;
  if (__get_cpuid(0x80000001, &a, &b, &c, &d) != 0) extended = c;
  if (!has_all(features, v2_ecx) || !has_all(extended, v2_extended_ecx)) return AXISRT_LEVEL_PORTABLE;
  b = 0;
  if (__get_cpuid_count(7, 0, &a, &b, &c, &d) == 0) b = 0;
  bool const has_v3 = has_all(features, v3_ecx) && has_all(b, v3_ebx) && has_all(extended, v3_extended_ecx) &&
                      (saved_registers() & vectors_256) == vectors_256;
  if (!has_v3) return AXISRT_LEVEL_X86_64_V2;
  bool const has_v4 = has_all(b, v4_ebx) && (saved_registers() & vectors_512) == vectors_512;
  return has_v4 ? AXISRT_LEVEL_X86_64_V4 : AXISRT_LEVEL_X86_64_V3;
}

Instructions const* find_native(uint32_t level) {
  uint32_t const best = best_x86_64_level();
  uint32_t const wanted = level == AXISRT_LEVEL_AUTOMATIC ? best : level;
  if (wanted > best) return nullptr;
  switch (wanted) {
    case AXISRT_LEVEL_X86_64_V4: return &x86_64_v4::instructions;
    case AXISRT_LEVEL_X86_64_V3: return &x86_64_v3::instructions;
    case AXISRT_LEVEL_X86_64_V2: return &x86_64_v2::instructions;
    case AXISRT_LEVEL_PORTABLE: return &portable::instructions;
    default: return nullptr;
  }
}

#elif defined(AXISRT_HAS_NEON)

Instructions const* find_native(uint32_t level) {
  bool const known = level == AXISRT_LEVEL_AUTOMATIC || level == AXISRT_LEVEL_NEON;
  return known ? &neon::instructions : nullptr;
}

#else

Instructions const* find_native(uint32_t level) {
  return level == AXISRT_LEVEL_AUTOMATIC ? &portable::instructions : nullptr;
}

#endif

}  // namespace

Instructions const* find_instructions(uint32_t level) {
  return level == AXISRT_LEVEL_PORTABLE ? &portable::instructions : find_native(level);
}

uint32_t lanes_of_level(uint32_t level) {
  switch (level) {
    case AXISRT_LEVEL_AUTOMATIC: return find_instructions(level)->lanes;
    case AXISRT_LEVEL_PORTABLE: return 1;
    case AXISRT_LEVEL_X86_64_V2:
    case AXISRT_LEVEL_NEON: return 2;
    case AXISRT_LEVEL_X86_64_V3: return 4;
    case AXISRT_LEVEL_X86_64_V4: return 8;
    default: return 0;
  }
}

}  // namespace axisc::runtime
