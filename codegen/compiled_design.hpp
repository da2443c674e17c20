// A filter or kernel as an image holds it: designed, with its figures and its self-test.
#pragma once

#include "codegen/proof.hpp"
#include "codegen/self_test.hpp"
#include "design/filter_design.hpp"
#include "design/kernels/kernel_design.hpp"

namespace axisc::codegen {

struct CompiledFilter {
  design::FilterDesign design;
  FilterProof proof;
  SelfTest self_test;
};

struct KernelProof {
  double peak_gain = 1;  ///< upper bound of Σ|b|
  double overshoot = 0;  ///< of the step response
  double tail_gain = 0;  ///< upper bound of Σ|S|
};

struct CompiledKernel {
  design::KernelDesign design;
  KernelProof proof;
  SelfTest self_test;
};

}  // namespace axisc::codegen
