// The part of the signal that a linear-phase kernel takes away, from the history of its increments:
//
//     E[n] = S_0 d[n] + S_1 d[n-1] + ...
//
// The history is a ring of blocks of eight cycles. With phase f in the present block b, the increment at
// place i of block b - c is f + 8 c - i cycles old, so that a block contributes
//     sum over i of S_(f + 8 c - i) d_(b - c, i).
// Tails with a negative index are zero: places after the phase in the present block do not count.
#pragma once

#include "runtime/lanes/lanes_def.hpp"

// Pieces of a group are some thousand doubles: offsets in them fit into 32 bits.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result)
namespace axisc::runtime::AXISRT_LEVEL {

inline constexpr uint32_t blocks_applied_directly = 2;

/// The block c before the present one.
AXISRT_INLINE uint32_t block_before(SlotGroup const& slot, uint32_t c) {
  return slot.block >= c ? slot.block - c : slot.block + slot.block_count - c;
}

template <uint32_t Width>
AXISRT_INLINE double const* increments_of(double const* history, uint32_t block) {
  return history + block * block_cycles * Width;
}

/// S_j: the same for all lanes, or one for each.
template <uint32_t Width, bool Common>
AXISRT_INLINE Real<Width> tail(double const* zero, uint32_t age, uint32_t place) {
  if constexpr (Common) {
    return all<Width>(*(zero - age + place));
  } else {
    return load_real<Width>(zero - static_cast<size_t>(age) * Width + static_cast<size_t>(place) * Width);
  }
}

/// Four sums side by side, so that no addition waits for the one before.
template <uint32_t Width>
struct FourSums {
  Real<Width> part[4] = {};
  [[nodiscard]] AXISRT_INLINE Real<Width> total() const { return (part[0] + part[1]) + (part[2] + part[3]); }
};

template <uint32_t Width, bool Common>
AXISRT_INLINE void add_block(double const* zero, uint32_t age, double const* increments,
                             FourSums<Width>& sums) {
  unrolled<block_cycles>([&]<uint32_t Place>() AXISRT_INLINE_LAMBDA {
    sums.part[Place % 4] +=
        tail<Width, Common>(zero, age, Place) * load_real<Width>(increments + Place * Width);
  });
}

/// One lane: the increments of a block and the tails of a kernel are both neighbours in memory, so that the
/// sums of a vector's lanes are added up at the end.
AXISRT_INLINE double apply_to_one(double const* zero, uint32_t blocks, SlotGroup const& slot,
                                  double const* history) {
  constexpr uint32_t lanes = AXISRT_LANES;
  constexpr uint32_t vectors = block_cycles / lanes;
  FourSums<lanes> sums;
  for (uint32_t c = 0; c < blocks; ++c) {
    double const* const increments = increments_of<1>(history, block_before(slot, c));
    double const* const tails = zero - (slot.phase + block_cycles * c);
    unrolled<vectors>([&]<uint32_t Vector>() AXISRT_INLINE_LAMBDA {
      sums.part[Vector % 4] +=
          load_real<lanes>(tails + Vector * lanes) * load_real<lanes>(increments + Vector * lanes);
    });
  }
  return sum_of_lanes<lanes>(sums.total());
}

/// E of kernels that are adjacent in `zero`, over the whole history.
template <uint32_t Width>
AXISRT_INLINE Real<Width> apply_directly(double const* zero, SlotGroup const& slot, double const* history) {
  if constexpr (Width == 1) {
    return only_lane(apply_to_one(zero, slot.block_count, slot, history));
  } else {
    FourSums<Width> sums;
    for (uint32_t c = 0; c < slot.block_count; ++c) {
      add_block<Width, false>(zero, slot.phase + block_cycles * c,
                              increments_of<Width>(history, block_before(slot, c)), sums);
    }
    return sums.total();
  }
}

/// Blocks of the history that a kernel reaches into, and how many of them one cycle applies ahead.
struct Reach {
  uint32_t blocks, blocks_a_cycle;
};

AXISRT_INLINE Reach reach_of(uint32_t blocks) {
  uint32_t const ahead = blocks > blocks_applied_directly ? blocks - blocks_applied_directly : 0;
  return {blocks, (ahead + block_cycles - 1) / block_cycles};
}

/// Applies a few old blocks to all eight outputs of the next block. An increment is read once for eight
/// outputs, and the work is the same in each of the eight cycles.
template <uint32_t Width, bool Common>
AXISRT_INLINE void gather_ahead(double const* zero, Reach reach, SlotGroup const& slot, double const* history,
                                double* ahead) {
  Real<Width> sums[block_cycles];
  unrolled<block_cycles>([&]<uint32_t Output>() AXISRT_INLINE_LAMBDA {
    sums[Output] = load_real<Width>(ahead + Output * Width);
  });
  uint32_t const first = blocks_applied_directly + slot.phase * reach.blocks_a_cycle;
  uint32_t const end =
      first + reach.blocks_a_cycle < reach.blocks ? first + reach.blocks_a_cycle : reach.blocks;
  for (uint32_t c = first; c < end; ++c) {
    // Seen from the next block, the block c before it is the one c - 1 before the present one.
    double const* const increments = increments_of<Width>(history, block_before(slot, c - 1));
    double const* const tails = zero - static_cast<size_t>(block_cycles) * c * (Common ? 1 : Width);
    unrolled<block_cycles>([&]<uint32_t Place>() AXISRT_INLINE_LAMBDA {
      auto const increment = load_real<Width>(increments + Place * Width);
      unrolled<block_cycles>([&]<uint32_t Output>() AXISRT_INLINE_LAMBDA {
        sums[Output] += tail<Width, Common>(tails, Output, Place) * increment;
      });
    });
  }
  unrolled<block_cycles>([&]<uint32_t Output>()
                             AXISRT_INLINE_LAMBDA { store<Width>(ahead + Output * Width, sums[Output]); });
}

/// E of the present cycle: the two latest blocks, and the part applied ahead.
template <uint32_t Width, bool Common>
AXISRT_INLINE Real<Width> apply_latest(double const* zero, SlotGroup const& slot, double const* history,
                                       double const* ahead) {
  FourSums<Width> sums;
  sums.part[0] = load_real<Width>(ahead + slot.phase * Width);
  unrolled<blocks_applied_directly>([&]<uint32_t Block>() AXISRT_INLINE_LAMBDA {
    add_block<Width, Common>(zero, slot.phase + block_cycles * Block,
                             increments_of<Width>(history, block_before(slot, Block)), sums);
  });
  return sums.total();
}

}  // namespace axisc::runtime::AXISRT_LEVEL
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result)
