// Resonances in a measured response, or the reason why it shows none.
#pragma once

#include "analysis/tuning/identification/measured_response.hpp"
#include "analysis/tuning/identification/thresholds.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace axisc::tuning {

struct Peak {
  double frequency = 0;              ///< Hz
  double frequency_uncertainty = 0;  ///< Hz
  double damping = 0;                ///< ratio
  double damping_uncertainty = 0;
  double magnitude = 0;               ///< of the response
  std::optional<double> coherence{};  ///< mean of the half-power band
  std::optional<double> ratio{};      ///< of the response and its deviation, median of the half-power band
};

enum class Doubt : std::uint8_t {
  too_short,      ///< fewer than fewest_samples, or not five points
  no_peak,        ///< nothing rises
  no_excitation,  ///< the input has no energy at the peak
  incoherent,     ///< the coherence at the peak is below lowest_coherence
  uncertain,      ///< the response at the peak is below lowest_ratio times its deviation
  noisy,          ///< the peak does not rise by 6 dB from what the response around it may be
  moving,         ///< the peak is elsewhere in each part of the recording
};

struct Identification {
  std::vector<Peak> peaks;        ///< by rising frequency, at most most_peaks; those of the largest magnitude
  std::optional<Doubt> doubt;     ///< present exactly where there are no peaks
  double doubtful_frequency = 0;  ///< Hz, of the largest peak that was not believed; 0: none
  double doubtful_ratio = 0;      ///< of an uncertain one
  double lowest = 0;              ///< Hz, from which on was searched
};

/// Searches between two frequencies.
[[nodiscard]] Identification identify(MeasuredResponse const& measured, double lowest, double highest);

/// Searches an input and an output that were sampled together. Peaks are those of Welch's estimate; local
/// polynomials over four parts (local_polynomial.hpp) say how certain each is; the quarters must agree.
[[nodiscard]] Identification identify(std::span<double const> in, std::span<double const> out,
                                      double sampling_rate, double lowest, double highest);

}  // namespace axisc::tuning
