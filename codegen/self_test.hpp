// The samples by which a controller finds out, before an axis moves, that its processor computes what the
// image demands.
#pragma once

#include "design/filter_design.hpp"
#include "design/kernels/kernel_design.hpp"

#include <vector>

namespace axisc::codegen {

struct SelfTest {
  std::vector<double> input;
  std::vector<double> output;  ///< of the stored coefficients, rounded once

  friend bool operator==(SelfTest const&, SelfTest const&) = default;
};

/// A processor passes when no output is further off than 2 ulp of the largest input, which is 1 and comes
/// last.
///
/// Round-off accumulates with every cycle, so the long part of the sequence is small against the tolerance.
/// The error that the step to 1 adds depends on the last bits of the states; where double arithmetic, with or
/// without contraction, would use up more than half of the tolerance, a slightly smaller amplitude of the
/// long part is taken. Cost: about 0.2 ms.
[[nodiscard]] SelfTest make_self_test(design::FilterDesign const& filter);

/// Samples of a linear-phase kernel that changes the signal.
[[nodiscard]] SelfTest make_self_test(design::KernelDesign const& kernel);

}  // namespace axisc::codegen
