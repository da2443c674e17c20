#include "runtime/bounds/standstill.hpp"

#include "runtime/bounds/outward.hpp"

namespace axisc::runtime::bounds {
namespace {

constexpr int32_t position_bits = 54;
constexpr int32_t cleared_bits = 501;  ///< |e| and |r| below 2^-501 each
constexpr int32_t bits_of_round = 23;
constexpr uint64_t cycles_to_clear = 6;

/// The least n with value <= 2^n, from 0 on.
int32_t bits_above_one(double value) {
  int32_t bits = 0;
  for (double power = 1; power < value; power *= 2) ++bits;
  return bits;
}

uint64_t cycles_of_section(SectionBound const& section, SectionSizes const& sizes) {
  double const s = section.scale;
  double const state = larger(s * sizes.e.position, sizes.r.position);
  // Until |s e| and |r| are below 2^-501 min(s, 1); in between A^n may let them grow by its norm.
  double const growth = larger(section.ee + section.er * s, section.re / s + section.rr);
  int32_t const bits =
      position_bits + cleared_bits + bits_above_one(state) + bits_above_one(1 / s) + bits_above_one(growth);
  auto const rounds = static_cast<uint64_t>((bits + bits_of_round - 1) / bits_of_round);
  return rounds * section.shrinking + cycles_to_clear;
}

}  // namespace

uint64_t rest_cycles(Chain const& chain, SectionSizes const* sizes, KernelPart const& kernel) {
  if (!chain.is_certain) return 0;
  // A moving average forgets in two of its windows, others in their tails and two blocks of eight.
  constexpr uint64_t cycles_of_blocks = 16;
  uint64_t cycles = 1 + uint64_t{chain.delay_cycles};
  if (kernel.count > 0) cycles += 2 * uint64_t{kernel.count} + cycles_of_blocks;
  for (uint32_t i = 0; i < chain.section_count; ++i) {
    cycles += cycles_of_section(chain.sections[i], sizes[i]);
  }
  return cycles;
}

}  // namespace axisc::runtime::bounds
