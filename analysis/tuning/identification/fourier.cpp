#include "analysis/tuning/identification/fourier.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace axisc::tuning {
namespace {

using Complex = std::complex<double>;

void by_halves(std::vector<Complex>& values) {
  std::size_t const count = values.size();
  for (std::size_t i = 1, j = 0; i < count; ++i) {
    std::size_t bit = count >> 1U;
    for (; (j & bit) != 0; bit >>= 1U) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(values[i], values[j]);
  }
  for (std::size_t size = 2; size <= count; size *= 2) {
    for (std::size_t k = 0; k < size / 2; ++k) {
      auto const turn =
          std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(size));
      for (std::size_t first = k; first < count; first += size) {
        auto const even = values[first];
        auto const odd = values[first + size / 2] * turn;
        values[first] = even + odd;
        values[first + size / 2] = even - odd;
      }
    }
  }
}

/// kn = (k² + n² - (k - n)²)/2 makes the transform a convolution with the chirp w_n = e^(jπ n²/N):
///     X_k = w*_k Σ_n (x_n w*_n) w_(k-n)
void by_chirp(std::vector<Complex>& values) {
  std::size_t const count = values.size();
  std::size_t const size = std::bit_ceil(2 * count);
  auto const length = static_cast<double>(count);
  std::vector<Complex> chirp(count);
  for (std::size_t n = 0; n < count; ++n) {
    // e^(jπ n²/N) has the period 2N in n²: small angles keep their digits.
    double const square = std::fmod(static_cast<double>(n) * static_cast<double>(n), 2 * length);
    chirp[n] = std::polar(1.0, std::numbers::pi * square / length);
  }
  std::vector<Complex> signal(size), kernel(size);
  for (std::size_t n = 0; n < count; ++n) {
    signal[n] = values[n] * std::conj(chirp[n]);
    kernel[n] = chirp[n];
    if (n > 0) kernel[size - n] = chirp[n];
  }
  by_halves(signal);
  by_halves(kernel);
  // The inverse transform is the conjugate of the transform of the conjugate.
  for (std::size_t i = 0; i < size; ++i) signal[i] = std::conj(signal[i] * kernel[i]);
  by_halves(signal);
  for (std::size_t k = 0; k < count; ++k) {
    values[k] = std::conj(signal[k]) / static_cast<double>(size) * std::conj(chirp[k]);
  }
}

}  // namespace

void transform(std::vector<Complex>& values) {
  if (std::has_single_bit(values.size())) {
    by_halves(values);
  } else {
    by_chirp(values);
  }
}

}  // namespace axisc::tuning
