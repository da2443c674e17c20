// The exact filter: unrounded coefficients, evaluated in 128-bit arithmetic.
#pragma once

#include "design/filter_specification.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace axisc::test {

class ExactChain {
 public:
  /// At rest at `position`.
  ExactChain(std::vector<design::FilterSpecification> const& filters, design::CycleTime cycle_time,
             double position);
  ~ExactChain();
  ExactChain(ExactChain const&) = delete;
  ExactChain& operator=(ExactChain const&) = delete;

  /// One cycle; `against` minus the exact output, rounded only then.
  double error_of(double against, double setpoint, double& exact_output);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace axisc::test
