// Kernels, convolution and nearest distances written down plainly, without any code of the folder under test:
// what a simulation says is compared with these.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace axisc::test {

/// Paths here move three axes at most.
using Place = std::array<double, 3>;

/// Taps b[n], n = 0, 1, …, of h = ceil(order / 2) cycles of delay.
[[nodiscard]] std::vector<double> average_taps(int order);
[[nodiscard]] std::vector<double> gaussian_taps(int order, double quality = 1);
[[nodiscard]] std::vector<double> sinc_taps(int order, double frequency_hz, double cycle_seconds);
/// One tap: a delay.
[[nodiscard]] std::vector<double> delay_taps(int cycles);
/// Impulse response of the bilinear PT1 whose gain at 1/(2π τ) is 3 dB down, until it has died away.
[[nodiscard]] std::vector<double> pt1_taps(double time_constant_us, double cycle_seconds);
[[nodiscard]] std::vector<double> in_series(std::vector<double> const& a, std::vector<double> const& b);

/// y[n] = Σ b[k] x[n - k]; before the first setpoint the axes rested at `start`.
[[nodiscard]] std::vector<Place> convolved(std::vector<Place> const& setpoints, Place const& start,
                                           std::vector<std::vector<double>> const& taps);

struct Distances {
  Place axis_error{};  ///< largest amount of each component
  double deviation = 0;

  [[nodiscard]] double largest() const;
};

/// Distances of the contour's points from the filtered path, per straight line of the contour. `contour`
/// begins where the axes rest; the setpoints `given` lie on it in their order. Looked at are its corners, the
/// setpoints and points from each to the next.
[[nodiscard]] std::vector<Distances> distances(std::vector<Place> const& contour,
                                               std::vector<Place> const& given,
                                               std::vector<std::vector<double>> const& taps,
                                               int points_between = 3);
/// The largest of them.
[[nodiscard]] Distances largest_of(std::vector<Distances> const& all);

}  // namespace axisc::test
