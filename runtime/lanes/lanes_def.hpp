// Values of several lanes: the compiler's vectors, and plain numbers for one lane.
//
// This and the other _def headers are compiled once for each instruction set, into a namespace of its own
// (AXISRT_LEVEL), with groups of up to AXISRT_LANES lanes. They use nothing that another level could define
// too: of two equal inline functions a linker keeps one, and it might be the one that this processor cannot
// execute.
#pragma once

#include "runtime/batch.hpp"
#include "runtime/compiler.hpp"
#include "runtime/limits.hpp"

#include <stddef.h>
#include <stdint.h>

// Pieces of a group are some thousand doubles: offsets in them fit into 32 bits.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result)
namespace axisc::runtime::AXISRT_LEVEL {

template <uint32_t Width>
struct Lanes;

// One lane is in a vector too where the processor has them: masks and numbers then stay in the same
// registers.
#if defined(__GNUC__) && defined(__SSE2__)
#define AXISRT_ONE_LANE_IN_VECTOR 1
#else
#define AXISRT_ONE_LANE_IN_VECTOR 0
#endif

template <>
struct Lanes<1> {
#if AXISRT_ONE_LANE_IN_VECTOR
  using Real = double __attribute__((vector_size(16)));
  using Bits = uint64_t __attribute__((vector_size(16)));
  using Signed = int64_t __attribute__((vector_size(16)));
#else
  using Real = double;
  using Bits = uint64_t;
  using Signed = int64_t;
#endif
};
#if AXISRT_LANES > 1
template <>
struct Lanes<2> {
  using Real = double __attribute__((vector_size(16)));
  using Bits = uint64_t __attribute__((vector_size(16)));
  using Signed = int64_t __attribute__((vector_size(16)));
  using Octets = uint8_t __attribute__((vector_size(2)));
};
template <>
struct Lanes<4> {
  using Real = double __attribute__((vector_size(32)));
  using Bits = uint64_t __attribute__((vector_size(32)));
  using Signed = int64_t __attribute__((vector_size(32)));
  using Octets = uint8_t __attribute__((vector_size(4)));
};
template <>
struct Lanes<8> {
  using Real = double __attribute__((vector_size(64)));
  using Bits = uint64_t __attribute__((vector_size(64)));
  using Signed = int64_t __attribute__((vector_size(64)));
  using Octets = uint8_t __attribute__((vector_size(8)));
};
#endif

template <uint32_t Width>
using Real = typename Lanes<Width>::Real;
template <uint32_t Width>
using Bits = typename Lanes<Width>::Bits;
template <uint32_t Width>
using Signed = typename Lanes<Width>::Signed;

/// A single number, without a vector around it.
template <uint32_t Width>
inline constexpr bool is_plain = Width == 1 && AXISRT_ONE_LANE_IN_VECTOR == 0;

/// The only lane.
AXISRT_INLINE Real<1> only_lane(double value) {
#if AXISRT_ONE_LANE_IN_VECTOR
  return Real<1>{value, 0};
#else
  return value;
#endif
}

AXISRT_INLINE Bits<1> only_bits(uint64_t bits) {
  return AXISRT_BIT_CAST(Bits<1>, only_lane(AXISRT_BIT_CAST(double, bits)));
}

template <class Vector>
AXISRT_INLINE auto lane_of(Vector const& value, uint32_t lane) {
  if constexpr (sizeof(Vector) == sizeof(double)) {
    return value;
  } else {
    return value[lane];
  }
}

/// From any address that is aligned to a double.
template <uint32_t Width>
AXISRT_INLINE Real<Width> load_real(void const* from) {
  if constexpr (Width == 1) {
    double value = 0;
    AXISRT_COPY(&value, from, sizeof value);
    return only_lane(value);
  } else {
    Real<Width> value;
    AXISRT_COPY(&value, from, sizeof value);
    return value;
  }
}

template <uint32_t Width>
AXISRT_INLINE Bits<Width> load_bits(void const* from) {
  return AXISRT_BIT_CAST(Bits<Width>, load_real<Width>(from));
}

template <uint32_t Width>
AXISRT_INLINE void store(void* to, Real<Width> value) {
  if constexpr (Width == 1) {
    double const only = lane_of(value, 0);
    AXISRT_COPY(to, &only, sizeof only);
  } else {
    AXISRT_COPY(to, &value, sizeof value);
  }
}

/// One number in every lane.
template <uint32_t Width>
AXISRT_INLINE Real<Width> all(double value) {
  if constexpr (Width == 1) {
    return only_lane(value);
  } else {
    return value - Real<Width>{};
  }
}

template <uint32_t Width>
AXISRT_INLINE Bits<Width> bits_of(Real<Width> value) {
  return AXISRT_BIT_CAST(Bits<Width>, value);
}

template <uint32_t Width>
AXISRT_INLINE Real<Width> real_of(Bits<Width> bits) {
  return AXISRT_BIT_CAST(Real<Width>, bits);
}

/// The mask unchanged, but opaque to the compiler, which otherwise turns selections between two numbers back
/// into branches.
AXISRT_INLINE uint64_t opaque(uint64_t mask) {
#if defined(__GNUC__)
  __asm__("" : "+r"(mask));
#endif
  return mask;
}

/// All bits of a lane set where a <= b; clear where one is NaN.
template <uint32_t Width>
AXISRT_INLINE Bits<Width> mask_if_at_most(Real<Width> a, Real<Width> b) {
  if constexpr (is_plain<Width>) {
    return opaque(0U - static_cast<uint64_t>(a <= b));
  } else {
    return AXISRT_BIT_CAST(Bits<Width>, a <= b);
  }
}

template <uint32_t Width>
AXISRT_INLINE Real<Width> magnitude(Real<Width> value) {
  return real_of<Width>(bits_of<Width>(value) & 0x7FFF'FFFF'FFFF'FFFFU);
}

template <uint32_t Width>
AXISRT_INLINE Real<Width> select(Bits<Width> mask, Real<Width> if_set, Real<Width> if_clear) {
  return real_of<Width>((bits_of<Width>(if_set) & mask) | (bits_of<Width>(if_clear) & ~mask));
}

/// The value or 0.
template <uint32_t Width>
AXISRT_INLINE Real<Width> keep(Bits<Width> mask, Real<Width> value) {
  return real_of<Width>(mask & bits_of<Width>(value));
}

/// All bits of a lane set where |value| < limit; clear for NaN. Compares as integers, so that neither a
/// subnormal number nor NaN leaves a trace in the control word.
template <uint32_t Width>
AXISRT_INLINE Bits<Width> mask_if_below(Real<Width> value, double limit) {
  auto const end = AXISRT_BIT_CAST(int64_t, limit);
  if constexpr (Width == 1) {
    auto const size = AXISRT_BIT_CAST(int64_t, lane_of(magnitude<Width>(value), 0));
    return only_bits(opaque(0U - static_cast<uint64_t>(size < end)));
  } else if constexpr (Width == 8) {
    // Comparing eight numbers makes a mask register, which compilers turn into a vector with an instruction
    // that waits for the previous value of its target: that of the group before.
    return AXISRT_BIT_CAST(Bits<Width>,
                           (AXISRT_BIT_CAST(Signed<Width>, magnitude<Width>(value)) - end) >> 63);
  } else {
    return AXISRT_BIT_CAST(Bits<Width>, AXISRT_BIT_CAST(Signed<Width>, magnitude<Width>(value)) < end);
  }
}

/// The value as a multiple of 2^-620 (sections_def.hpp).
template <uint32_t Width>
AXISRT_INLINE Real<Width> on_grid(Real<Width> value) {
  return (value + all<Width>(grid)) - all<Width>(grid);
}

/// The value unchanged, but opaque to the compiler: keeps it from merging a rounded product with a following
/// sum where an error term depends on the rounding.
template <uint32_t Width>
AXISRT_INLINE Real<Width> rounded(Real<Width> value) {
#if defined(AXISRT_CONTRACTS) && defined(__x86_64__)
  __asm__("" : "+x"(value));
#elif defined(AXISRT_CONTRACTS) && defined(__aarch64__)
  if constexpr (Width <= 2) __asm__("" : "+w"(value));
#endif
  return value;
}

template <uint32_t Width>
AXISRT_INLINE double sum_of_lanes(Real<Width> value) {
  double sum = lane_of(value, 0);
  for (uint32_t lane = 1; lane < Width; ++lane) sum += lane_of(value, lane);
  return sum;
}

/// Values of lines that need not be neighbours.
template <uint32_t Width>
AXISRT_INLINE Real<Width> gather(double const* values, uint32_t const* lines) {
  if constexpr (Width == 1) {
    return only_lane(values[lines[0]]);
#if AXISRT_LANES > 1
  } else if constexpr (Width == 2) {
    return Real<2>{values[lines[0]], values[lines[1]]};
  } else if constexpr (Width == 4) {
    return Real<4>{values[lines[0]], values[lines[1]], values[lines[2]], values[lines[3]]};
  } else {
    return Real<8>{values[lines[0]], values[lines[1]], values[lines[2]], values[lines[3]],
                   values[lines[4]], values[lines[5]], values[lines[6]], values[lines[7]]};
#endif
  }
}

/// Calls call.template operator()<0>() to <Count - 1>(): an unrolled loop.
template <uint32_t Count, uint32_t First = 0, class Call>
AXISRT_INLINE void unrolled(Call const& call) {
  if constexpr (First < Count) {
    call.template operator()<First>();
    unrolled<Count, First + 1>(call);
  }
}

/// Numbers 0 to Count - 1 as template arguments.
template <uint32_t... Member>
struct Members {};
template <uint32_t Count, uint32_t... Member>
struct CountMembers : CountMembers<Count - 1, Count - 1, Member...> {};
template <uint32_t... Member>
struct CountMembers<0, Member...> {
  using Type = Members<Member...>;
};
template <uint32_t Count>
using FirstMembers = typename CountMembers<Count>::Type;

}  // namespace axisc::runtime::AXISRT_LEVEL
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result)
