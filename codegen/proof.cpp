#include "codegen/proof.hpp"

#include "design/filter_analysis.hpp"

namespace axisc::codegen {
namespace {

/// Where the analysis may stop: what then still moves adds less than this to Σ|h|.
constexpr double settled_within = 1e-9;

}  // namespace

FilterProof prove_filter(design::FilterDesign const& filter) {
  design::StepFigures const step = design::step_figures(std::span(&filter, 1), longest_proof, settled_within);
  return {.pole_radius = filter.pole_radius,
          .dc_gain = filter.dc_gain,
          .group_delay = filter.group_delay_cycles,
          .kernel_sum = 1,
          .peak_gain = step.peak_gain,
          .overshoot = step.overshoot};
}

ChainProof prove_chain(std::span<design::FilterDesign const> chain) {
  return {.peak_gain = design::step_figures(chain, longest_proof, settled_within).peak_gain,
          .delay_cycles = design::chain_delay_cycles(chain)};
}

}  // namespace axisc::codegen
