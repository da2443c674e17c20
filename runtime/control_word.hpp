// The arithmetic of every call: round to nearest, no traps. Whether subnormal numbers are taken as zero does
// not matter in a cycle, which never meets one (lanes/sections_def.hpp). A caller may have set any control
// word and gets it back; writing it takes longer than the filters of four axes, so that a cycle does so only
// if it must.
#pragma once

#include "runtime/compiler.hpp"

#include <stdint.h>

#if defined(_M_X64) && !defined(__GNUC__)
#include <xmmintrin.h>
#endif

namespace axisc::runtime {

#if defined(__x86_64__) || defined(_M_X64)

struct ControlWord {
  using Word = uint32_t;
  static Word read() {
#if defined(__x86_64__)
    return __builtin_ia32_stmxcsr();
#else
    return _mm_getcsr();
#endif
  }
  static void write(Word word) {
#if defined(__x86_64__)
    __builtin_ia32_ldmxcsr(word);
#else
    _mm_setcsr(word);
#endif
  }
  static constexpr Word wanted = 0x1F80;     ///< all exceptions masked, round to nearest
  static constexpr Word subnormal = 0x8040;  ///< flush to zero, denormals are zero
  static constexpr Word inexact = 0x0020;
  static constexpr Word flags = 0x003F;  ///< exceptions seen so far
};

#elif defined(__aarch64__)

struct ControlWord {
  using Word = uint64_t;
  static Word read() {
    Word word = 0;
    __asm__ volatile("mrs %0, fpcr" : "=r"(word)::"memory");
    return word;
  }
  static void write(Word word) { __asm__ volatile("msr fpcr, %0" ::"r"(word) : "memory"); }
  static constexpr Word wanted = 0;
  static constexpr Word subnormal = Word{1} << 24U;
  static constexpr Word inexact = 0;
  static constexpr Word flags = 0;  ///< in a register of their own
};

#elif defined(__arm__) && defined(__ARM_FP) && (__ARM_FP & 8) != 0

struct ControlWord {
  using Word = uint32_t;
  static Word read() {
    Word word = 0;
    __asm__ volatile("vmrs %0, fpscr" : "=r"(word)::"memory");
    return word;
  }
  static void write(Word word) { __asm__ volatile("vmsr fpscr, %0" ::"r"(word) : "memory"); }
  static constexpr Word wanted = 0;
  static constexpr Word subnormal = Word{1} << 24U;
  static constexpr Word inexact = 0x10;
  static constexpr Word flags = 0xF000'009F;  ///< flags of comparisons and exceptions
};

#else

/// Processors without such a word.
struct ControlWord {
  using Word = uint32_t;
  static Word read() { return 0; }
  static void write(Word /*word*/) {}
  static constexpr Word wanted = 0;
  static constexpr Word subnormal = 0;
  static constexpr Word inexact = 0;
  static constexpr Word flags = 0;
};

#endif

/// Changes the word if one of its bits, apart from the flags and those that do not matter, is not the wanted
/// one. Afterwards the caller's word is restored, with the flags of `Left` added that were raised meanwhile.
template <ControlWord::Word Indifferent, ControlWord::Word Left>
class Arithmetic {
 public:
  Arithmetic() : callers_(ControlWord::read()), changed_(!is_wanted(callers_)) {
    if (changed_) ControlWord::write(ControlWord::wanted);
  }
  ~Arithmetic() {
    if (changed_ || has_other_flags()) ControlWord::write(callers_);
  }
  Arithmetic(Arithmetic const&) = delete;
  Arithmetic& operator=(Arithmetic const&) = delete;

  /// Nothing needs to be changed. Reading the word waits for all computations before it.
  [[nodiscard]] static bool is_in_force() { return is_wanted(ControlWord::read()); }

 private:
  static bool is_wanted(ControlWord::Word word) {
    return (word & ~(Indifferent | ControlWord::flags)) == ControlWord::wanted;
  }
  [[nodiscard]] bool has_other_flags() const { return ((ControlWord::read() ^ callers_) & ~Left) != 0; }
  ControlWord::Word callers_;
  bool changed_;
};

/// The control word of a cycle, where nearly every computation is inexact: that flag stays as the cycle
/// leaves it.
using CycleArithmetic = Arithmetic<ControlWord::subnormal, ControlWord::inexact>;

/// The control word of all other calls, which may meet subnormal numbers.
using PlainArithmetic = Arithmetic<0, 0>;

/// Calls `work`. Compilers know nothing about control words and may move computations past a change of them,
/// but not out of a function.
template <class Work>
AXISRT_APART auto apart(Work const& work) {
  return work();
}

template <class Work>
auto in_plain_arithmetic(Work const& work) {
  [[maybe_unused]] PlainArithmetic const arithmetic;
  return apart(work);
}

template <class Work>
auto in_cycle_arithmetic(Work const& work) {
  [[maybe_unused]] CycleArithmetic const arithmetic;
  return apart(work);
}

}  // namespace axisc::runtime
