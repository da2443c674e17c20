// A linear-phase kernel as a plain convolution in quadruple precision: y[n] = sum of b_j x[n-j].
#pragma once

#include "runtime/quad.hpp"

#include <cstddef>
#include <deque>
#include <vector>

namespace axisc::test {

/// Starts from the steady state for a position. The taps follow from the tail sums: b_0 = 1 - S_0, b_j =
/// S_(j-1) - S_j.
class ExactKernel {
 public:
  ExactKernel(std::vector<double> const& tails, Quad position) : inputs_(tails.size() + 1, position) {
    Quad before = 1;
    for (double const tail : tails) {
      taps_.push_back(before - static_cast<Quad>(tail));
      before = tail;
    }
    taps_.push_back(before);
  }

  [[nodiscard]] Quad step(Quad x) {
    inputs_.push_front(x);
    inputs_.pop_back();
    Quad y = 0;
    for (std::size_t j = 0; j < taps_.size(); ++j) y += taps_[j] * inputs_[j];
    return y;
  }

 private:
  std::vector<Quad> taps_;
  std::deque<Quad> inputs_;
};

}  // namespace axisc::test
