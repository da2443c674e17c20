#include "runtime/creation/building.hpp"
#include "runtime/double_bits.hpp"
#include "runtime/limits.hpp"

namespace axisc::runtime {
namespace {

/// The factor s of tails s (K - j), apart from their rounding; 0 for other kernels.
double find_ramp(double const* zero, uint32_t tail_count) {
  constexpr double rounding = 0x1p-50;
  if (tail_count < 2) return 0;
  double const ramp = zero[0] / tail_count;
  for (uint32_t j = 0; j < tail_count; ++j) {
    double const tail = *(zero - j);
    if (!is_within(ramp * (tail_count - j) - tail, rounding * magnitude(tail))) return 0;
  }
  return ramp;
}

/// Puts a kernel's tails in falling order into memory, with zeros around them; returns the place of S_0.
template <class Tail>
double const* write_tails(double* memory, uint32_t block_count, uint32_t tail_count, Tail tail) {
  uint32_t const last = block_count * block_cycles - 1;
  for (uint32_t i = 0; i < padded_tails(block_count); ++i) memory[i] = 0;
  for (uint32_t j = 0; j < tail_count; ++j) memory[last - j] = tail(j);
  return memory + last;
}

}  // namespace

void build_kernels(ImageView const& view, Layout const& layout, Memory memory) {
  auto* tails = memory.part<double>(layout.tails);
  auto* const kernels = memory.part<Kernel>(layout.kernels);
  for (uint32_t i = 0; i <= view.kernels.count; ++i) {
    uint32_t first = 0;
    uint32_t count = 0;
    if (i < view.kernels.count) {
      first = view.kernels[i][field::kernel::first_tail];
      count = view.kernels[i][field::kernel::tail_count];
    }
    uint32_t const blocks = blocks_of(count);
    double const* const zero = write_tails(tails, blocks, count, [&](uint32_t j) {
      return unless_below(smallest_tail, view.tails[first + j][field::tail::value]);
    });
    kernels[i] = {.zero = zero,
                  .tail_count = count,
                  .block_count = blocks,
                  .ramp = find_ramp(zero, count),
                  .length = static_cast<double>(count)};
    tails += padded_tails(blocks);
  }
}

}  // namespace axisc::runtime
