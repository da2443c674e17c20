#include "grammar/regular_lines.hpp"

#include <cstddef>

// The C library has asked the processor already: in a virtual machine every question costs microseconds, more than wider
// vectors save in a short list. (Clang does not read this header as C++.)
#if defined(AXISC_HAS_AVX2_LEVEL) && __has_include(<sys/platform/x86.h>) && !defined(__clang__)
#include <sys/platform/x86.h>
#endif

namespace axisc::grammar {

namespace portable {
std::size_t read_regular_lines(RegularLines& lines, Assignment* out, std::size_t room);
}
#if defined(AXISC_HAS_AVX2_LEVEL)
namespace avx2 {
std::size_t read_regular_lines(RegularLines& lines, Assignment* out, std::size_t room);
}
#endif

namespace {

#if defined(AXISC_HAS_AVX2_LEVEL)

RegularLineReader find_avx2_reader() {
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
  return usable ? avx2::read_regular_lines : nullptr;
}

#else

RegularLineReader find_avx2_reader() {
  return nullptr;
}

#endif

}  // namespace

RegularLineReader find_regular_line_reader(Way way) {
  if (way == Way::by_grammar) return nullptr;
  if (way == Way::portable) return portable::read_regular_lines;
  RegularLineReader const wide = find_avx2_reader();
  return wide == nullptr && way == Way::quick ? portable::read_regular_lines : wide;
}

}  // namespace axisc::grammar
