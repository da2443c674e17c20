// Resonances in a measured response, or the reason why it shows none.
#pragma once

#include "analysis/tuning/identification/measured_response.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace axisc::tuning {

/// Below this coherence noise or something else than the input moves the output.
inline constexpr double lowest_coherence = 0.8;
/// Power of the input as a share of its largest: below it, the input cannot show a resonance.
inline constexpr double lowest_excitation = 1e-5;
/// A peak rises above the valleys on either side by this factor (6 dB).
inline constexpr double peak_prominence = 2;
/// A peak that is found in the quarters of a recording at frequencies which differ by more than this share,
/// and by more than the resolution, is not one resonance.
inline constexpr double largest_movement = 0.06;
/// Fewer samples show nothing.
inline constexpr std::size_t fewest_samples = 2048;
inline constexpr std::size_t most_peaks = 3;

struct Peak {
  double frequency = 0;              ///< Hz
  double frequency_uncertainty = 0;  ///< Hz
  double damping = 0;                ///< ratio
  double damping_uncertainty = 0;
  double magnitude = 0;               ///< of the response
  std::optional<double> coherence{};  ///< mean of the half-power band
};

enum class Doubt : std::uint8_t {
  too_short,      ///< fewer than fewest_samples, or not five points
  no_peak,        ///< nothing rises
  no_excitation,  ///< the input has no energy at the peak
  incoherent,     ///< the coherence at the peak is below lowest_coherence
  moving,         ///< the peak is elsewhere in each part of the recording
};

struct Identification {
  std::vector<Peak> peaks;        ///< by rising frequency, at most most_peaks; those of the largest magnitude
  std::optional<Doubt> doubt;     ///< present exactly where there are no peaks
  double doubtful_frequency = 0;  ///< Hz, of the largest peak that was not believed; 0: none
};

/// Searches between two frequencies.
[[nodiscard]] Identification identify(MeasuredResponse const& measured, double lowest, double highest);

/// Searches an input and an output that were sampled together; the four quarters of the recording must agree.
[[nodiscard]] Identification identify(std::span<double const> in, std::span<double const> out,
                                      double sampling_rate, double lowest, double highest);

}  // namespace axisc::tuning
