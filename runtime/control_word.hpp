// Arithmetic of a cycle: round to nearest, no exceptions, subnormal numbers taken as zero (they cost a hundred times as
// much on some processors). The caller's control word comes back afterwards.
#pragma once

#include <stdint.h>

namespace axisc::runtime {

#if defined(__x86_64__)

class CycleArithmetic {
 public:
  CycleArithmetic() : callers_(__builtin_ia32_stmxcsr()), changed_((callers_ & ~flags) != wanted) {
    if (changed_) __builtin_ia32_ldmxcsr(wanted);
  }
  ~CycleArithmetic() {
    if (changed_) __builtin_ia32_ldmxcsr(callers_);
  }
  CycleArithmetic(CycleArithmetic const&) = delete;
  CycleArithmetic& operator=(CycleArithmetic const&) = delete;

 private:
  static constexpr uint32_t flags = 0x003F;
  static constexpr uint32_t wanted = 0x9FC0;  ///< flush to zero, all exceptions masked, denormals are zero
  uint32_t callers_;
  bool changed_;
};

#elif defined(__aarch64__) || (defined(__arm__) && defined(__ARM_FP) && (__ARM_FP & 8) != 0)

class CycleArithmetic {
 public:
#if defined(__aarch64__)
  using Word = uint64_t;
  static Word read() {
    Word word = 0;
    __asm__ volatile("mrs %0, fpcr" : "=r"(word)::"memory");
    return word;
  }
  static void write(Word word) {
    __asm__ volatile("msr fpcr, %0" ::"r"(word) : "memory");
  }
#else
  using Word = uint32_t;
  static Word read() {
    Word word = 0;
    __asm__ volatile("vmrs %0, fpscr" : "=r"(word)::"memory");
    return word;
  }
  static void write(Word word) {
    __asm__ volatile("vmsr fpscr, %0" ::"r"(word) : "memory");
  }
#endif
  CycleArithmetic() : callers_(read()) {
    write(flush_to_zero);
  }
  ~CycleArithmetic() {
    write(callers_);
  }
  CycleArithmetic(CycleArithmetic const&) = delete;
  CycleArithmetic& operator=(CycleArithmetic const&) = delete;

 private:
  static constexpr Word flush_to_zero = Word{1} << 24U;
  Word callers_;
};

#else

/// Processors that handle subnormal numbers at full speed, or have no such switch.
class [[maybe_unused]] CycleArithmetic {
 public:
  CycleArithmetic() = default;
};

#endif

}  // namespace axisc::runtime
