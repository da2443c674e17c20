// Every distinct linear-phase kernel of a machine is designed, proved and given its self-test once, however many axes
// and banks use it.
#pragma once

#include "codegen/self_test.hpp"
#include "design/kernel_design.hpp"

#include <cstdint>
#include <vector>

namespace axisc::codegen {

/// Index of no kernel: the setpoint passes unchanged.
inline constexpr std::uint32_t no_kernel = 0xFFFFFFFF;

struct KernelProof {
  double peak_gain = 1;  ///< Σ|b|
  double overshoot = 0;  ///< of the step response
  double tail_gain = 0;  ///< Σ|S|
};

struct CompiledKernel {
  design::KernelSpecification specification;  ///< what its type ignores stands at its default
  design::KernelDesign design;
  KernelProof proof;
  SelfTest self_test;
};

class CompiledKernels {
 public:
  explicit CompiledKernels(design::CycleTime cycle_time) : cycle_time_(cycle_time) {}

  /// Index of the kernel, designed now if it is new; no_kernel where it would let the signal pass.
  [[nodiscard]] std::uint32_t index_of(design::KernelSpecification const& specification);
  [[nodiscard]] CompiledKernel const& operator[](std::uint32_t index) const { return kernels_[index]; }
  [[nodiscard]] std::vector<CompiledKernel> const& all() const { return kernels_; }

 private:
  design::CycleTime cycle_time_;
  std::vector<CompiledKernel> kernels_;
};

}  // namespace axisc::codegen
