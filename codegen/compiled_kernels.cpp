#include "codegen/compiled_kernels.hpp"

#include "design/kernels/kernel_kinds.hpp"

#include <algorithm>

namespace axisc::codegen {
namespace {

/// Equal kernels have equal specifications.
design::KernelSpecification normalised(design::KernelSpecification specification,
                                       design::CycleTime cycle_time) {
  design::KernelSpecification const defaults;
  design::KernelKind const& kind = design::kind_of(specification.type);
  if (!kind.uses_frequency) specification.frequency = defaults.frequency;
  if (!kind.uses_quality) specification.quality = defaults.quality;
  specification.reading = design::applied_reading(specification);
  if (!kind.uses_frequency) specification.cycle_time = defaults.cycle_time;
  if (kind.computes_order) {
    specification.order =
        design::novib_order(specification.frequency, design::as_read(cycle_time, specification.cycle_time));
  }
  return specification;
}

}  // namespace

std::uint32_t CompiledKernels::index_of(design::KernelSpecification const& specification) {
  if (specification.order == 0 || design::passes_unchanged(specification)) return no_kernel;
  design::KernelSpecification const wanted = normalised(specification, cycle_time_);
  auto const known = std::find_if(kernels_.begin(), kernels_.end(), [&](MachineKernel const& kernel) {
    return kernel.specification == wanted;
  });
  if (known != kernels_.end()) return static_cast<std::uint32_t>(known - kernels_.begin());
  kernels_.push_back({.specification = wanted, .compiled = designs_.kernel(wanted, cycle_time_)});
  return static_cast<std::uint32_t>(kernels_.size() - 1);
}

}  // namespace axisc::codegen
