// Which readings of `motion` explain a recording of a program?
//
// Readings act together, so every combination of them is planned, move by move, and laid over the recording.
// A reading is told where each combination that leaves nothing but rounding has it. A control that plans as
// one of the combinations says is among those that fit, so that nothing wrong is told about it. A move that
// none of them explains by itself is something else, and is left out: the others may tell their readings.
#pragma once

#include "analysis/comparison/motion/program_moves.hpp"
#include "analysis/comparison/motion/recorded_path.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace axisc::comparison {

/// A combination, with its deviation over all moves.
struct ExplainedMotion {
  Combination readings{};
  Deviation deviation;
};

struct MotionKeyVerdict {
  bool acts = false;  ///< in a move that is explained
  /// Numbers of the words with which a combination fits, rising.
  std::vector<std::uint8_t> possible = {};
  /// The best combination with another word than the one that is told.
  std::optional<ExplainedMotion> next = std::nullopt;

  [[nodiscard]] bool is_told() const { return acts && possible.size() == 1; }
};

/// A move that no combination explains.
struct UnexplainedMove {
  std::uint32_t line = 0;  ///< of the program, where it begins
  std::string block;       ///< "N040"
  double largest = 0;      ///< deviation with the combination that fits best, position units
};

struct MotionComparison {
  std::size_t moves = 0, cycles = 0;  ///< compared
  ExplainedMotion current;            ///< the readings in force, over all moves
  /// Of all combinations, over the moves that are explained; over all where none is. The first one that fits,
  /// where several do.
  ExplainedMotion best;
  std::vector<UnexplainedMove> unexplained;
  std::array<MotionKeyVerdict, motion_key_count> keys;

  /// The control plans as axisc does, as far as this program shows.
  [[nodiscard]] bool agrees() const { return current.deviation.fits(); }
};

/// The program's moves are not in the recording, one after the other with the same ways between rests.
struct NoSuchMoves {
  std::size_t programmed = 0;  ///< that move an axis with a column
  std::size_t recorded = 0;
};

/// `dynamics.readings` are those in force. The program has a move, and each lasts no longer than the
/// recording. Cost: each move is planned in at most 576 ways, and each plan compared with its part of the
/// recording a few dozen times, mostly with the first cycles of it only.
[[nodiscard]] std::variant<MotionComparison, NoSuchMoves> compare_motion(std::vector<Move> const& moves,
                                                                         motion::PathDynamics const& dynamics,
                                                                         RecordedPath const& path);

}  // namespace axisc::comparison
