// The arithmetic of every call: round to nearest, no exceptions. The caller's control word comes back afterwards, and the
// exceptions that he has seen so far, so that he may have set it to anything.
#pragma once

#include <stdint.h>

namespace axisc::runtime {

#if defined(__x86_64__)

class Arithmetic {
 public:
  Arithmetic(Arithmetic const&) = delete;
  Arithmetic& operator=(Arithmetic const&) = delete;

 protected:
  explicit Arithmetic(uint32_t wanted)
      : callers_(__builtin_ia32_stmxcsr()), changed_((callers_ & ~flags) != wanted) {
    if (changed_) __builtin_ia32_ldmxcsr(wanted);
  }
  ~Arithmetic() {
    if (changed_ || __builtin_ia32_stmxcsr() != callers_) __builtin_ia32_ldmxcsr(callers_);
  }

  static constexpr uint32_t masked = 0x1F80;          ///< all exceptions, and round to nearest
  static constexpr uint32_t subnormal_zero = 0x8040;  ///< flush to zero, denormals are zero

 private:
  static constexpr uint32_t flags = 0x003F;
  uint32_t callers_;
  bool changed_;
};

/// That of a cycle: subnormal numbers are taken as zero, since they cost a hundred times as much on some processors.
class CycleArithmetic : Arithmetic {
 public:
  CycleArithmetic() : Arithmetic(masked | subnormal_zero) {}
};

/// That of all other calls.
class PlainArithmetic : Arithmetic {
 public:
  PlainArithmetic() : Arithmetic(masked) {}
};

#elif defined(__aarch64__) || (defined(__arm__) && defined(__ARM_FP) && (__ARM_FP & 8) != 0)

class Arithmetic {
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
  Arithmetic(Arithmetic const&) = delete;
  Arithmetic& operator=(Arithmetic const&) = delete;

 protected:
  explicit Arithmetic(Word wanted) : callers_(read()) {
    write(wanted);
  }
  ~Arithmetic() {
    write(callers_);
  }

  static constexpr Word flush_to_zero = Word{1} << 24U;

 private:
  Word callers_;
};

class CycleArithmetic : Arithmetic {
 public:
  CycleArithmetic() : Arithmetic(flush_to_zero) {}
};

class PlainArithmetic : Arithmetic {
 public:
  PlainArithmetic() : Arithmetic(0) {}
};

#else

/// Processors that handle subnormal numbers at full speed, or have no such switch.
class [[maybe_unused]] CycleArithmetic {
 public:
  CycleArithmetic() = default;
};

class [[maybe_unused]] PlainArithmetic {
 public:
  PlainArithmetic() = default;
};

#endif

/// Calls `work`. A compiler knows nothing of control words and may move what it computes past a change of them, but not out of a
/// function.
template <class Work>
[[gnu::noinline]] auto apart(Work const& work) {
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
