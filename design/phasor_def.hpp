// cos and sin of equally spaced angles: one rotation per step instead of two series.
#pragma once

#include <cmath>

namespace axisc::design {

/// e^(j(start + k·step)), k = 0, 1, 2, …
/// After k steps the error is about k roundings; while all angles stay below π/2 that holds relative to the
/// sine too, because both products of its sum are positive.
template <typename Number>
class Phasor {
 public:
  Phasor(Number const& start, Number const& step) {
    using std::cos;
    using std::sin;
    cosine_ = cos(start);
    sine_ = sin(start);
    step_cosine_ = cos(step);
    step_sine_ = sin(step);
  }

  [[nodiscard]] Number const& cosine() const { return cosine_; }
  [[nodiscard]] Number const& sine() const { return sine_; }

  void advance() {
    Number const cosine = cosine_ * step_cosine_ - sine_ * step_sine_;
    sine_ = sine_ * step_cosine_ + cosine_ * step_sine_;
    cosine_ = cosine;
  }

 private:
  Number cosine_{1}, sine_{0};
  Number step_cosine_{1}, step_sine_{0};
};

}  // namespace axisc::design
