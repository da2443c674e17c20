// A filter or kernel as an image holds it: designed, with its figures and its self-test.
#pragma once

#include "codegen/proof.hpp"
#include "codegen/self_test.hpp"
#include "design/filter_design.hpp"
#include "design/kernels/kernel_design.hpp"

#include <mutex>
#include <utility>

namespace axisc::codegen {

template <class Design, class Proof>
class CompiledDesign {
 public:
  CompiledDesign(Design designed, Proof proved) : design(std::move(designed)), proof(proved) {}

  Design design;
  Proof proof;

  /// Made when it is first asked for: images are also written without. Several threads may ask.
  [[nodiscard]] SelfTest const& self_test() const {
    std::call_once(made_, [this] { self_test_ = make_self_test(design); });
    return self_test_;
  }

 private:
  mutable std::once_flag made_;
  mutable SelfTest self_test_;
};

struct KernelProof {
  double peak_gain = 1;  ///< upper bound of Σ|b|
  double overshoot = 0;  ///< of the step response
  double tail_gain = 0;  ///< upper bound of Σ|S|
};

using CompiledFilter = CompiledDesign<design::FilterDesign, FilterProof>;
using CompiledKernel = CompiledDesign<design::KernelDesign, KernelProof>;

}  // namespace axisc::codegen
