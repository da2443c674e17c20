// The moves of an NC program: what the path does between two rests.
#pragma once

#include "analysis/comparison/motion/reading_combinations.hpp"
#include "analysis/motion/path_listener.hpp"
#include "analysis/motion/planning/axis_mode.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace axisc::comparison {

struct Move {
  motion::Point begin{};
  std::vector<motion::ProgrammedBlock> blocks;  ///< each of them moves

  [[nodiscard]] motion::Point const& end() const { return blocks.back().end; }
};

/// Why a program cannot be compared with a recording.
enum class MoveProblemKind : std::uint8_t {
  short_pause,    ///< the path stops for less than shortest_pause_s: a recording does not show where
  filter_command  ///< #FILTER, whose tolerance and factor change the plan
};

struct MoveProblem {
  MoveProblemKind kind = MoveProblemKind::short_pause;
  std::uint32_t line = 0;  ///< of the program
};

/// Of the rests between moves. Slow parts of a move may look like a rest for less than that.
inline constexpr double shortest_pause_s = 0.2;

/// Takes what an interpreter says of a program.
class ProgramMoves final : public motion::PathListener {
 public:
  explicit ProgramMoves(design::CycleTime cycle_time) : cycle_time_(cycle_time) {}

  void motion(motion::ProgrammedBlock const& block) override;
  void command(motion::FilterChange const& change) override;
  void stop(double cycles, std::uint32_t line) override;
  void end() override {}

  [[nodiscard]] std::vector<Move> const& moves() const { return moves_; }
  /// The first one.
  [[nodiscard]] std::optional<MoveProblem> const& problem() const { return problem_; }

 private:
  void refuse(MoveProblemKind kind, std::uint32_t line);

  design::CycleTime cycle_time_;
  std::vector<Move> moves_;
  motion::Point position_{};
  bool is_moving_ = false;
  double pause_ = 0;             ///< since the last move, cycles
  std::uint32_t stop_line_ = 0;  ///< where the path stopped
  std::optional<MoveProblem> problem_;
};

/// The keys whose readings may change how a move is planned; readings of others never do.
[[nodiscard]] MotionKeys acting_keys(Move const& move, motion::PathDynamics const& dynamics);

}  // namespace axisc::comparison
