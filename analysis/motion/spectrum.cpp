#include "analysis/motion/spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace axisc::motion {

namespace {

/// Frequencies that are computed at once, so that the processor's vectors are used.
constexpr std::size_t lanes = 8;

struct Windowed {
  std::vector<double> record;  ///< w x, the mean taken off
  double weights = 0;          ///< Σ w
};

Windowed windowed(std::span<double const> record) {
  auto const count = static_cast<double>(record.size());
  double mean = 0;
  for (double const x : record) mean += x / count;
  // Phasors turn step by step: their error stays far below what is measured.
  auto const turn = std::polar(1.0, 2 * std::numbers::pi / count);
  auto phasor = std::polar(1.0, std::numbers::pi / count);
  Windowed found;
  found.record.reserve(record.size());
  for (double const x : record) {
    double const weight = 0.5 - 0.5 * phasor.real();
    found.record.push_back(weight * (x - mean));
    found.weights += weight;
    phasor *= turn;
  }
  return found;
}

}  // namespace

double amplitude_at(std::span<double const> record, double cycle_seconds, double frequency) {
  return amplitudes_at(record, cycle_seconds, std::span(&frequency, 1)).front();
}

std::vector<double> amplitudes_at(std::span<double const> record, double cycle_seconds,
                                  std::span<double const> frequencies) {
  std::vector<double> amplitudes(frequencies.size(), 0.0);
  if (record.empty()) return amplitudes;
  auto const [values, weights] = windowed(record);
  for (std::size_t first = 0; first < frequencies.size(); first += lanes) {
    std::size_t const count = std::min(lanes, frequencies.size() - first);
    std::array<double, lanes> turn_re{}, turn_im{}, re{}, im{}, sum_re{}, sum_im{};
    for (std::size_t i = 0; i < count; ++i) {
      auto const turn = std::polar(1.0, -2 * std::numbers::pi * frequencies[first + i] * cycle_seconds);
      turn_re.at(i) = turn.real();
      turn_im.at(i) = turn.imag();
      re.at(i) = 1;
    }
    for (double const x : values) {
      for (std::size_t i = 0; i < lanes; ++i) {
        sum_re[i] += x * re[i];
        sum_im[i] += x * im[i];
        double const next = re[i] * turn_re[i] - im[i] * turn_im[i];
        im[i] = re[i] * turn_im[i] + im[i] * turn_re[i];
        re[i] = next;
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      amplitudes[first + i] = 2 * std::abs(std::complex(sum_re.at(i), sum_im.at(i))) / weights;
    }
  }
  return amplitudes;
}

Oscillation dominant_oscillation(std::span<double const> record, double cycle_seconds, double lowest,
                                 double highest) {
  std::vector<double> frequencies;
  for (auto tenths = static_cast<int>(std::ceil(lowest * 10)); tenths <= highest * 10; ++tenths) {
    frequencies.push_back(tenths / 10.0);
  }
  auto const amplitudes = amplitudes_at(record, cycle_seconds, frequencies);
  Oscillation found{.frequency = lowest, .amplitude = 0};
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    if (amplitudes[i] > found.amplitude) found = {.frequency = frequencies[i], .amplitude = amplitudes[i]};
  }
  return found;
}

}  // namespace axisc::motion
