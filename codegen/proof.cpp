#include "codegen/proof.hpp"

#include "design/filter_analysis.hpp"

#include <algorithm>

namespace axisc::codegen {
namespace {

/// Not used for any decision: no proof states when a filter has settled.
constexpr double settled_within = 1e-9;

/// Where step_figures knows no bound, next to half the sampling rate: above every gain, and still a number.
constexpr double no_bound = 0x1p500;

}  // namespace

FilterProof prove_filter(design::FilterDesign const& filter) {
  design::StepFigures const step =
      design::step_figures(std::span(&filter, 1), design::longest_summation, settled_within);
  return {.pole_radius = filter.pole_radius,
          .dc_gain = filter.dc_gain,
          .group_delay = filter.group_delay_cycles,
          .kernel_sum = 1,
          .peak_gain = std::min(step.peak_gain_bound, no_bound),
          .overshoot = step.overshoot};
}

ChainProof prove_chain(std::span<design::FilterDesign const> chain) {
  design::StepFigures const step = design::step_figures(chain, design::longest_summation, settled_within);
  return {.peak_gain = std::min(step.peak_gain_bound, no_bound),
          .delay_cycles = design::chain_delay_cycles(chain)};
}

}  // namespace axisc::codegen
