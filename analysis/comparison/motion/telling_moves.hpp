// The moves of an NC program that tell the readings of `motion` apart on a given machine.
#pragma once

#include "analysis/comparison/motion/program_moves.hpp"
#include "analysis/motion/program/channel.hpp"

#include <array>
#include <string>
#include <vector>

namespace axisc::comparison {

/// Lines of a program, there and back, for one key.
struct TellingMoves {
  MotionKey key = MotionKey::cycles;
  std::vector<std::string> lines;
  std::vector<Move> moves;  ///< that the lines describe
};

enum class Outlook : std::uint8_t {
  told,    ///< whatever the control does
  partly,  ///< with some readings of the other keys only, or some of its own readings
  not_told
};

struct TellingProgram {
  std::vector<std::string> opening;  ///< lines before the moves: units, a rest
  std::vector<TellingMoves> parts;   ///< in the order of the keys
  std::array<Outlook, motion_key_count> outlook{};
};

/// Chooses the first of a few short moves, gentle ones first, that differ by more than recordings with steps
/// of 0.1 µm or 0.0001° hide. Moves begin wherever the axes are, and end there. Cost: some hundred plans of
/// moves of seconds.
[[nodiscard]] TellingProgram telling_program(motion::ProgramChannel const& channel,
                                             motion::PathDynamics const& dynamics);

/// Seconds that the axes rest after each move.
inline constexpr double telling_pause_s = 0.3;

}  // namespace axisc::comparison
