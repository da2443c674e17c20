// Lines that rise from the spectrum of one piece of a signal.
#pragma once

#include <span>
#include <vector>

namespace axisc::tuning {

struct Line {
  double frequency = 0;  ///< Hz, between the entries of the spectrum
  double amplitude = 0;  ///< of the sine, in the unit of the signal
};

/// Straight line taken off, Hann window; what rises by line_height (thresholds.hpp) from its neighbours.
/// Neighbours that rise together are one line, at the centre of their power: noise splits a resonance.
[[nodiscard]] std::vector<Line> lines_of(std::span<double const> signal, double sampling_rate, double lowest,
                                         double highest);

}  // namespace axisc::tuning
