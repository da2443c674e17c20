// The distinct linear-phase kernels of a machine, however many axes and banks use them.
#pragma once

#include "codegen/known_designs.hpp"

#include <cstdint>
#include <vector>

namespace axisc::codegen {

/// Index of no kernel: the setpoint passes unchanged.
inline constexpr std::uint32_t no_kernel = 0xFFFFFFFF;

struct MachineKernel {
  design::KernelSpecification specification;  ///< with default values where its type ignores them
  KnownDesigns::Kernel compiled;              ///< never null
};

class CompiledKernels {
 public:
  /// `designs` must outlive this.
  CompiledKernels(KnownDesigns& designs, design::CycleTime cycle_time)
      : designs_(designs), cycle_time_(cycle_time) {}

  /// Index of the kernel, which is added if it is new; no_kernel where the signal would pass unchanged.
  [[nodiscard]] std::uint32_t index_of(design::KernelSpecification const& specification);
  [[nodiscard]] CompiledKernel const& operator[](std::uint32_t index) const {
    return *kernels_[index].compiled;
  }
  [[nodiscard]] std::vector<MachineKernel> const& all() const { return kernels_; }

 private:
  KnownDesigns& designs_;
  design::CycleTime cycle_time_;
  std::vector<MachineKernel> kernels_;
};

}  // namespace axisc::codegen
