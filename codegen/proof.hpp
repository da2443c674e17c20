// What is known about a filter and a chain before they run; the image's proof records.
#pragma once

#include "design/filter_design.hpp"

#include <cstdint>
#include <span>

namespace axisc::codegen {

struct FilterProof {
  double pole_radius = 0;  ///< largest |pole|
  double dc_gain = 1;      ///< gain at 0 Hz, share included
  double group_delay = 0;  ///< at 0 Hz in NC cycles, share included
  double kernel_sum = 1;   ///< 1 for sections and delays
  double peak_gain = 1;    ///< Σ|h[n]|
  double overshoot = 0;    ///< of the step response, as a share of its final value
};

struct ChainProof {
  double peak_gain = 1;
  double delay_cycles = 0;
};

/// The figures are the same on every host: what is not taken from the design, which rounds once, comes from
/// sums and products in double in a fixed order. Cost: proportional to the settling time, at most
/// `longest_proof` cycles.
inline constexpr std::uint64_t longest_proof = std::uint64_t{1} << 21U;

[[nodiscard]] FilterProof prove_filter(design::FilterDesign const& filter);
/// `chain` is not empty.
[[nodiscard]] ChainProof prove_chain(std::span<design::FilterDesign const> chain);

}  // namespace axisc::codegen
