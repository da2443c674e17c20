// Amplitude and frequency of oscillations in a record.
#pragma once

#include <span>
#include <vector>

namespace axisc::motion {

struct Oscillation {
  double frequency = 0;  ///< Hz
  double amplitude = 0;  ///< in the record's unit
};

/// Amplitude of the sine of one frequency:  2 |Σ w x e^(-jωn)| / Σ w  with a Hann window w, the mean taken
/// off. For a decaying oscillation, about the amplitude in the middle of the record.
[[nodiscard]] double amplitude_at(std::span<double const> record, double cycle_seconds, double frequency);
/// The same of each of many frequencies. Cost: eight take little longer than one.
[[nodiscard]] std::vector<double> amplitudes_at(std::span<double const> record, double cycle_seconds,
                                                std::span<double const> frequencies);

/// The largest oscillation between two frequencies, on a grid of 0.1 Hz.
[[nodiscard]] Oscillation dominant_oscillation(std::span<double const> record, double cycle_seconds,
                                               double lowest, double highest);

}  // namespace axisc::motion
