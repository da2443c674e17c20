#include "grammar/plain_lines.hpp"

// The C library has asked the processor already: in a virtual machine every question costs microseconds, more than wider
// vectors save in a short list. (Clang does not read this header as C++.)
#if defined(AXISC_HAS_AVX2_LEVEL) && __has_include(<sys/platform/x86.h>) && !defined(__clang__)
#include <sys/platform/x86.h>
#endif

namespace axisc::grammar {

namespace portable {
extern PlainLineReader const plain_line_reader;
}
#if defined(AXISC_HAS_AVX2_LEVEL)
namespace avx2 {
extern PlainLineReader const plain_line_reader;
}
#endif

namespace {

#if defined(AXISC_HAS_AVX2_LEVEL)

PlainLineReader const* find_avx2_reader() {
#if defined(CPU_FEATURE_ACTIVE)
  bool const usable = CPU_FEATURE_ACTIVE(AVX2) && CPU_FEATURE_ACTIVE(BMI1) && CPU_FEATURE_ACTIVE(BMI2) &&
                      CPU_FEATURE_ACTIVE(LZCNT) && CPU_FEATURE_ACTIVE(POPCNT);
#else
  bool usable = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
                __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("popcnt");
#if !defined(__clang__)
  usable = usable && __builtin_cpu_supports("lzcnt");
#endif
#endif
  return usable ? &avx2::plain_line_reader : nullptr;
}

#else

PlainLineReader const* find_avx2_reader() {
  return nullptr;
}

#endif

}  // namespace

PlainLineReader const* find_plain_line_reader(Way way) {
  if (way == Way::by_grammar) return nullptr;
  if (way == Way::portable) return &portable::plain_line_reader;
  PlainLineReader const* const wide = find_avx2_reader();
  return wide == nullptr && way == Way::quick ? &portable::plain_line_reader : wide;
}

}  // namespace axisc::grammar
