#include "codegen/compiled_kernels.hpp"

#include "design/kernel_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axisc::codegen {
namespace {

constexpr double settled_within = 1e-9;

/// Equal kernels have equal specifications.
design::KernelSpecification normalised(design::KernelSpecification specification,
                                       design::CycleTime cycle_time) {
  design::KernelSpecification const defaults;
  using design::KernelType;
  bool const uses_frequency =
      specification.type == KernelType::windowed_sinc || specification.type == KernelType::novib;
  if (!uses_frequency) specification.frequency = defaults.frequency;
  if (specification.type != KernelType::gaussian) specification.quality = defaults.quality;
  if (specification.type == KernelType::novib) {
    specification.order = design::novib_order(specification.frequency, cycle_time);
  }
  return specification;
}

KernelProof prove(design::KernelDesign const& design) {
  design::StepFigures const step = design::step_figures(design, settled_within);
  KernelProof proof{.peak_gain = step.peak_gain, .overshoot = step.overshoot, .tail_gain = 0};
  for (double const tail : design.tail_sums) proof.tail_gain += std::abs(tail);
  return proof;
}

}  // namespace

std::uint32_t CompiledKernels::index_of(design::KernelSpecification const& specification) {
  if (specification.order == 0 || design::passes_unchanged(specification)) return no_kernel;
  design::KernelSpecification const wanted = normalised(specification, cycle_time_);
  auto const known = std::find_if(kernels_.begin(), kernels_.end(), [&](CompiledKernel const& kernel) {
    return kernel.specification == wanted;
  });
  if (known != kernels_.end()) return static_cast<std::uint32_t>(known - kernels_.begin());

  design::KernelDesign design = design::design_kernel(wanted, cycle_time_);
  KernelProof const proof = prove(design);
  SelfTest self_test = make_self_test(design);
  kernels_.push_back({.specification = wanted,
                      .design = std::move(design),
                      .proof = proof,
                      .self_test = std::move(self_test)});
  return static_cast<std::uint32_t>(kernels_.size() - 1);
}

}  // namespace axisc::codegen
