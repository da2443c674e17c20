// Facts about a filter and a chain, known before they run; the image's proof records.
#pragma once

#include "design/filter_design.hpp"

#include <span>

namespace axisc::codegen {

struct FilterProof {
  double pole_radius = 0;  ///< largest |pole| of the stored coefficients
  double dc_gain = 1;      ///< gain at 0 Hz, share included
  double group_delay = 0;  ///< at 0 Hz in NC cycles, share included
  double kernel_sum = 1;   ///< 1 for sections and delays
  double peak_gain = 1;    ///< upper bound of Σ|h[n]|
  double overshoot = 0;    ///< of the step response, as a share of its final value
};

struct ChainProof {
  double peak_gain = 1;  ///< upper bound of Σ|h[n]|
  double delay_cycles = 0;
};

/// The figures are the same on every host. Cost: that of design::step_figures, for design::longest_summation
/// cycles at most.
[[nodiscard]] FilterProof prove_filter(design::FilterDesign const& filter);
/// `chain` is not empty.
[[nodiscard]] ChainProof prove_chain(std::span<design::FilterDesign const> chain);

}  // namespace axisc::codegen
