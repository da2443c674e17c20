// A response that was measured, or estimated from two signals.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace axisc::tuning {

/// One entry for each frequency; vectors of what is not known are empty.
struct MeasuredResponse {
  std::vector<double> frequency;               ///< Hz, rising
  std::vector<std::complex<double>> response;  ///< without phase: real magnitudes
  bool has_phase = false;
  std::vector<double> coherence;   ///< 0 to 1
  std::vector<double> excitation;  ///< power density of the input, in any unit

  [[nodiscard]] double resolution() const;
};

/// Welch's method: Hann windows of `length` samples that overlap by half, means taken off,
///     H = S_xy / S_xx,  γ² = |S_xy|² / (S_xx S_yy).
/// `length` is a power of two of at most the signals' common size. The constant part is left out.
[[nodiscard]] MeasuredResponse estimate_response(std::span<double const> in, std::span<double const> out,
                                                 double sampling_rate, std::size_t length);

}  // namespace axisc::tuning
