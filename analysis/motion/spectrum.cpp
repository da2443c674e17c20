#include "analysis/motion/spectrum.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace axisc::motion {

double amplitude_at(std::span<double const> record, double cycle_seconds, double frequency) {
  auto const count = static_cast<double>(record.size());
  if (record.empty()) return 0;
  double mean = 0;
  for (double const x : record) mean += x / count;
  // The phasor turns step by step: its error stays far below what is measured.
  auto const turn = std::polar(1.0, -2 * std::numbers::pi * frequency * cycle_seconds);
  auto const window_turn = std::polar(1.0, 2 * std::numbers::pi / count);
  std::complex<double> phasor = 1;
  auto window_phasor = std::polar(1.0, std::numbers::pi / count);
  std::complex<double> sum = 0;
  double weights = 0;
  for (double const x : record) {
    double const weight = 0.5 - 0.5 * window_phasor.real();
    sum += weight * (x - mean) * phasor;
    weights += weight;
    phasor *= turn;
    window_phasor *= window_turn;
  }
  return 2 * std::abs(sum) / weights;
}

Oscillation dominant_oscillation(std::span<double const> record, double cycle_seconds, double lowest,
                                 double highest) {
  Oscillation found{.frequency = lowest, .amplitude = 0};
  for (auto tenths = static_cast<int>(std::ceil(lowest * 10)); tenths <= highest * 10; ++tenths) {
    double const frequency = tenths / 10.0;
    double const amplitude = amplitude_at(record, cycle_seconds, frequency);
    if (amplitude > found.amplitude) found = {.frequency = frequency, .amplitude = amplitude};
  }
  return found;
}

}  // namespace axisc::motion
