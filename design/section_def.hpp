// A second-order section in increment form before it is rounded.
#pragma once

#include <cmath>
#include <limits>

namespace axisc::design {

/// See IncrementSection. A first-order section has b = 1 and q = 0.
template <typename Number>
struct Section {
  Number p{0};
  Number q{0};
  Number k{0};
  Number b{0};
  Number slope{0};  ///< (p + q)/k: H = 1 + slope·jω or H = slope·jω next to ω = 0
};

/// Largest |z| with A(z) = 0. In v = z - 1 the poles are the roots of v² + (k + b) v + k.
template <typename Number>
[[nodiscard]] Number pole_radius(Section<Number> const& section) {
  using std::abs;
  using std::sqrt;
  Number const sum = section.k + section.b;
  Number const discriminant = sum * sum - 4 * section.k;
  // A double pole is meant where rounding alone separates the two.
  Number const noise = 64 * std::numeric_limits<Number>::epsilon() * sum * sum;
  if (discriminant < -noise) return sqrt(1 - section.b);
  if (discriminant <= noise) return abs(1 - sum / 2);
  Number const far = -(sum + sqrt(discriminant)) / 2;
  Number const near = section.k / far;
  Number const radius_far = abs(1 + far);
  Number const radius_near = abs(1 + near);
  return radius_far > radius_near ? radius_far : radius_near;
}

}  // namespace axisc::design
