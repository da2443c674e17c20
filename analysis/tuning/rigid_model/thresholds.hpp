// What recordings of motion must show before a mass or a friction is believed: every threshold of the search.
//
// Where no reason is given, a threshold was chosen on the simulated axes of
// tests/analysis/tuning/axis_recordings.py, and judged on others that had no part in the choice.
#pragma once

#include <cstddef>
#include <cstdint>

namespace axisc::tuning {

// Of motion.

/// s, in all, and of either direction: what is shorter is not ordinary motion, but one move.
inline constexpr double shortest_motion = 1;
inline constexpr double shortest_direction = 0.1;

// Of windows.

/// Samples of the shortest window: its fourth differences have some resolution from here on.
inline constexpr std::size_t shortest_window = 6;
/// s: what is longer averages the acceleration away.
inline constexpr double longest_first_window = 0.1;
/// s: the fourth derivative takes longer windows to stand out from a coarse position.
inline constexpr double longest_first_elastic_window = 0.2;
/// Of the variance of what a window measures, that the noise of the position may have: as a share it lowers
/// the mass by as much.
inline constexpr double largest_noise_share = 0.01;
/// Up to this multiple of the first length, and to the longest first one at least, windows are tried.
inline constexpr double longest_window_ratio = 4;
inline constexpr std::size_t window_lengths = 7;
/// Windows overlap: each begins a quarter of its length after the one before.
inline constexpr std::size_t windows_per_length = 4;
/// Of the highest speed: an axis that is slower may turn back, and its friction is not that of sliding.
inline constexpr double slowest_motion = 0.03;
/// s: half of the span over which the speed is taken, as in motion_pieces.hpp.
inline constexpr double half_speed_span = 0.01;

// Of fits.

/// Samples by which the recorded force may come before or after the motion that it makes.
inline constexpr int earliest_force = -1, latest_force = 6;
/// Residuals beyond this multiple of their standard deviation count less: 95 % efficiency with a normal
/// distribution (Huber 1964).
inline constexpr double huber_width = 1.345;
/// Blocks of the bootstrap: fewer cannot vary, more would be shorter than what disturbs them.
inline constexpr std::size_t fewest_blocks = 4, most_blocks = 40;
inline constexpr std::size_t windows_per_block = 8;
/// So that every other window still has both directions.
inline constexpr std::size_t fewest_windows_of_direction = 4;
inline constexpr std::size_t resamplings = 200;
inline constexpr std::uint32_t bootstrap_seed = 1;

// Of what is given.

/// The half width of the bootstrap's 95 % interval counts one and a half times, because blocks are not
/// independent.
inline constexpr double interval_factor = 1.5;
/// Of each value: what the model leaves out (resonances, drives that step) even where windows agree.
inline constexpr double model_uncertainty = 0.03;
/// Of the variance of the force in every other window, that a fit to those between them must explain.
inline constexpr double least_explained_force = 0.8;
/// Root mean square of the accelerating force as a share of the varying one.
inline constexpr double least_accelerating = 0.1;
/// Of the value.
inline constexpr double largest_mass_uncertainty = 0.1;
inline constexpr double largest_coulomb_uncertainty = 0.15;
inline constexpr double largest_viscous_uncertainty = 0.3;

}  // namespace axisc::tuning
