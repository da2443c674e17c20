// A kernel as the specification writes its execution: y[n] = x[n] - Σ_j S_j d[n-j].
#pragma once

#include "design/kernels/kernel_design.hpp"

#include <cstddef>
#include <deque>

/// Starts from the steady state for 0.
class KernelFilter {
 public:
  explicit KernelFilter(axisc::design::KernelDesign const& kernel)
      : kernel_(kernel), increments_(kernel.tail_sums.size(), 0.0) {}

  double step(double x) {
    increments_.push_front(x - previous_);
    previous_ = x;
    double sum = 0;
    for (std::size_t j = 0; j < kernel_.tail_sums.size(); ++j) sum += kernel_.tail_sums[j] * increments_[j];
    increments_.pop_back();
    return x - sum;
  }

 private:
  axisc::design::KernelDesign kernel_;
  std::deque<double> increments_;
  double previous_ = 0;
};
