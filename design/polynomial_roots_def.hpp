// Roots of real polynomials of low degree whose roots are simple.
#pragma once

#include "design/complex_number.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace axisc::design {

/// Coefficients a[0] + a[1] x + ... + a[n] x^n, a[n] not 0.
template <typename Number>
using Polynomial = std::vector<Number>;

/// Value and derivative at x, by Horner's scheme.
template <typename Number, typename Argument>
void evaluate(Polynomial<Number> const& a, Argument const& x, Argument& value, Argument& derivative) {
  value = Argument{a.back()};
  derivative = Argument{Number(0)};
  for (std::size_t i = a.size() - 1; i-- > 0;) {
    derivative = derivative * x + value;
    value = value * x + Argument{a[i]};
  }
}

/// All roots in double, by the simultaneous iteration of Aberth:
///     x_i -= N / (1 - N Σ_{j≠i} 1/(x_i - x_j)),   N = a(x_i)/a'(x_i)
/// Uses no function but +, -, ·, / and is therefore the same on every host.
inline std::vector<ComplexNumber<double>> roots_in_double(Polynomial<double> const& a) {
  using Complex = ComplexNumber<double>;
  std::vector<Complex> x(a.size() - 1);
  Complex start{1, 0};
  for (Complex& root : x) root = start = start * Complex{0.4, 0.9};

  constexpr int most_iterations = 100;
  constexpr double relative_step = 1e-14;
  bool moving = true;
  for (int iteration = 0; moving && iteration < most_iterations; ++iteration) {
    moving = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
      Complex value, derivative;
      evaluate(a, x[i], value, derivative);
      if (square_of_magnitude(value) == 0) continue;
      Complex const newton = value / derivative;
      Complex repulsion;
      for (std::size_t j = 0; j < x.size(); ++j) {
        if (j != i) repulsion = repulsion + Complex{1, 0} / (x[i] - x[j]);
      }
      Complex const step = newton / (Complex{1, 0} - newton * repulsion);
      x[i] = x[i] - step;
      moving =
          moving || square_of_magnitude(step) > relative_step * relative_step * square_of_magnitude(x[i]);
    }
  }
  return x;
}

/// Newton's iteration from a good start until the steps no longer shrink.
template <typename Number, typename Argument, typename Size>
[[nodiscard]] Argument polish(Polynomial<Number> const& a, Argument x, Size square_of_size) {
  constexpr int most_iterations = 12;
  Argument value{Number(0)}, derivative{Number(0)};
  Number previous{0};
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    evaluate(a, x, value, derivative);
    Argument const step = value / derivative;
    Number const size = square_of_size(step);
    if (iteration > 0 && size >= previous) break;
    x = x - step;
    if (size == 0) break;
    previous = size;
  }
  return x;
}

/// The roots, each to the precision of Number: real ones with im = 0, of conjugate pairs the one with im > 0.
template <typename Number>
[[nodiscard]] std::vector<ComplexNumber<Number>> polynomial_roots(Polynomial<Number> const& a) {
  Polynomial<double> rounded;
  rounded.reserve(a.size());
  for (Number const& coefficient : a) rounded.push_back(static_cast<double>(coefficient));

  // Far above the error of the start values, far below the angles between simple roots.
  constexpr double real_angle = 1e-7;
  std::vector<ComplexNumber<Number>> roots;
  for (ComplexNumber<double> const& start : roots_in_double(rounded)) {
    if (start.im * start.im <= real_angle * real_angle * square_of_magnitude(start)) {
      roots.push_back({polish(a, Number(start.re), [](Number const& x) { return x * x; }), Number(0)});
    } else if (start.im > 0) {
      roots.push_back(polish(a, ComplexNumber<Number>{Number(start.re), Number(start.im)},
                             [](ComplexNumber<Number> const& x) { return square_of_magnitude(x); }));
    }
  }
  return roots;
}

}  // namespace axisc::design
