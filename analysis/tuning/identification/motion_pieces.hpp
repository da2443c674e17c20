// Where the setpoint of a recording rests, and where it moves at constant speed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace axisc::tuning {

/// What the first signal of a recording is.
enum class InputKind : std::uint8_t {
  position,  ///< setpoint
  velocity,  ///< setpoint
  force,     ///< or torque: it says nothing about rest or speed
};

/// Samples [first, first + count).
struct Piece {
  std::size_t first = 0, count = 0;
  double speed = 0;  ///< units of the setpoint a second, not negative; 0: at rest
};

struct MotionPieces {
  std::vector<Piece> rests;     ///< of shortest_rest and fewest_rest_samples at least, after a motion
  std::vector<Piece> constant;  ///< of shortest_piece and fewest_piece_samples at least
};

/// The output while the axis moves at constant speed, or while it rests. The recording must outlive it.
struct SteadySignal {
  std::span<double const> values;
  double sampling_rate = 0;  ///< Hz
  double speed = 0;          ///< units of the setpoint a second; 0: at rest
};

/// Empty for a force.
[[nodiscard]] MotionPieces motion_pieces(std::span<double const> setpoint, double sampling_rate,
                                         InputKind kind);

}  // namespace axisc::tuning
