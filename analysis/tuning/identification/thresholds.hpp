// What a recording must show before a resonance is believed: every threshold of the search.
//
// Most were set on real recordings of few machines, the others on simulated axes
// (tests/analysis/tuning/mode_recordings.py), and no independent recording was left to try them on: a change
// needs new ones, not an opinion.
#pragma once

#include <array>
#include <cstddef>

namespace axisc::tuning {

// Of a response.

/// Below this coherence noise or something else than the input moves the output, in a response that brings
/// its coherence along.
inline constexpr double lowest_coherence = 0.8;
/// |h| of the local polynomials as a multiple of its standard deviation, the median of the half-power band.
inline constexpr double lowest_ratio = 5;
/// The same of a quarter of the recording, which need only show where the peak is.
inline constexpr double lowest_ratio_of_quarter = 2;
/// Power of the input as a share of its largest: below it, the input cannot show a resonance.
inline constexpr double lowest_excitation = 1e-5;
/// A peak rises above the valleys on either side by this factor (6 dB).
inline constexpr double peak_prominence = 2;
/// Seconds of a part of a response: longer recordings have more parts.
inline constexpr double longest_part = 16;
/// A peak that is found in the quarters of a recording at frequencies which differ by more than this share,
/// and by more than the resolution, is not one resonance.
inline constexpr double largest_movement = 0.06;
/// Fewer samples show no response.
inline constexpr std::size_t fewest_samples = 2048;

// Of ring-down.

inline constexpr double shortest_rest = 0.08;  ///< s
inline constexpr std::size_t fewest_rest_samples = 20;
inline constexpr std::size_t fewest_rests = 4;
/// What the sine must explain of what offset and decays leave, and of the whole settling.
inline constexpr double least_explained = 0.6;
inline constexpr double least_of_settling = 0.02;
inline constexpr double largest_half_difference = 0.06;  ///< of the frequency, between the halves
inline constexpr double largest_damping = 0.25;
inline constexpr double fewest_periods = 2.4;  ///< in a rest
/// What is left of an amplitude at the end of a rest: above it nothing rings down, something keeps shaking.
inline constexpr double largest_remainder = 0.5;

// Of lines in the spectrum.

inline constexpr double shortest_piece = 0.2;  ///< s, at constant speed
inline constexpr std::size_t fewest_piece_samples = 128;
inline constexpr std::size_t fewest_pieces = 3;
inline constexpr double constant_speed = 0.01;    ///< by which the speed of a piece may vary
inline constexpr double slowest_share = 0.05;     ///< of the highest speed
inline constexpr double different_speeds = 1.15;  ///< as a ratio
inline constexpr double line_height = 10;         ///< of power, above the median of the neighbours: 10 dB
inline constexpr std::size_t line_neighbours = 40;
inline constexpr double line_movement = 0.4;         ///< lines
inline constexpr double line_movement_share = 0.01;  ///< of the frequency; the larger one of both counts
/// Of the way that a line would move if it were proportional to the speed: more is not standing still.
inline constexpr double movement_with_speed = 0.25;
inline constexpr double most_pieces_share = 0.8;  ///< that must show the line
/// At rest something else than the motion shakes the axis where the second half of a rest has this share of
/// the line's amplitude in motion, and of that in the first half.
inline constexpr double rest_share = 0.5;
inline constexpr double rest_remainder = 0.7;
/// Multiples of the mains' frequencies are shown, and not used.
inline constexpr std::array mains_frequencies{50.0, 60.0};  ///< Hz
inline constexpr double mains_distance = 0.5;               ///< Hz

// Of all kinds.

inline constexpr double lowest_frequency = 2;         ///< Hz
inline constexpr double highest_share = 0.4;          ///< of the sampling rate
inline constexpr double largest_disagreement = 0.05;  ///< of a frequency, between kinds of evidence
inline constexpr std::size_t most_peaks = 3;

}  // namespace axisc::tuning
