// Complex numbers over any number type; std::complex is defined for the built-in floating types only.
#pragma once

#include <cmath>

namespace axisc::design {

template <typename Number>
struct ComplexNumber {
  Number re{0};
  Number im{0};

  friend ComplexNumber operator+(ComplexNumber const& x, ComplexNumber const& y) {
    return {x.re + y.re, x.im + y.im};
  }
  friend ComplexNumber operator-(ComplexNumber const& x, ComplexNumber const& y) {
    return {x.re - y.re, x.im - y.im};
  }
  friend ComplexNumber operator*(ComplexNumber const& x, ComplexNumber const& y) {
    return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
  }
  friend ComplexNumber operator/(ComplexNumber const& x, ComplexNumber const& y) {
    Number const n = square_of_magnitude(y);
    return {(x.re * y.re + x.im * y.im) / n, (x.im * y.re - x.re * y.im) / n};
  }
  friend Number square_of_magnitude(ComplexNumber const& x) { return x.re * x.re + x.im * x.im; }
};

/// The root with a real part that is not negative.
template <typename Number>
[[nodiscard]] ComplexNumber<Number> square_root(ComplexNumber<Number> const& x) {
  using std::sqrt;
  Number const magnitude = sqrt(square_of_magnitude(x));
  if (magnitude == 0) return {};
  // The larger of the two parts first: the other one follows from 2·re·im = x.im without cancellation.
  if (x.re >= 0) {
    Number const re = sqrt((magnitude + x.re) / 2);
    return {re, x.im / (2 * re)};
  }
  Number const im = sqrt((magnitude - x.re) / 2);
  return x.im >= 0 ? ComplexNumber<Number>{x.im / (2 * im), im}
                   : ComplexNumber<Number>{-x.im / (2 * im), -im};
}

}  // namespace axisc::design
