#include "comparison/prototype_gain.hpp"

#include <cmath>
#include <complex>
#include <vector>

namespace axisc::comparison {

namespace {

/// |θ_n(0) / θ_n(jω)|² of the reverse Bessel polynomials, by θ_n = (2n - 1) θ_(n-1) + s² θ_(n-2).
double bessel_power(std::uint32_t order, double omega) {
  auto const theta = [order](std::complex<double> s) {
    std::complex<double> last = 1, current = s + 1.0;
    for (std::uint32_t n = 2; n <= order; ++n) {
      auto const next = (2.0 * n - 1) * current + s * s * last;
      last = current;
      current = next;
    }
    return current;
  };
  return std::norm(theta(0)) / std::norm(theta({0, omega}));
}

}  // namespace

double bessel_cutoff(std::uint32_t order) {
  double low = 0, high = 1;
  while (bessel_power(order, high) > 0.5) high *= 2;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    double const middle = (low + high) / 2;
    (bessel_power(order, middle) > 0.5 ? low : high) = middle;
  }
  return low;
}

double frequency_with_power(design::Prototype prototype, std::uint32_t order, double power) {
  double const n = order;
  switch (prototype) {
    case design::Prototype::critical_damping:  // (1 + ω² (2^(1/n) - 1))^-n
      return std::sqrt((std::pow(power, -1 / n) - 1) / (std::pow(2.0, 1 / n) - 1));
    case design::Prototype::butterworth:  // (1 + ω^2n)^-1
      return std::pow(1 / power - 1, 1 / (2 * n));
    case design::Prototype::bessel:
      break;
  }
  double const cutoff = bessel_cutoff(order);
  double low = 0, high = 1;
  while (bessel_power(order, high * cutoff) > power) high *= 2;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    double const middle = (low + high) / 2;
    (bessel_power(order, middle * cutoff) > power ? low : high) = middle;
  }
  return low;
}

}  // namespace axisc::comparison
