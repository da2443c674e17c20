#include "analysis/comparison/motion/program_moves.hpp"

#include <algorithm>
#include <utility>

namespace axisc::comparison {

void ProgramMoves::refuse(MoveProblemKind kind, std::uint32_t line) {
  if (!problem_) problem_ = MoveProblem{.kind = kind, .line = line};
}

void ProgramMoves::motion(motion::ProgrammedBlock const& block) {
  if (!block.arc && block.end == position_) return;
  if (!std::exchange(is_moving_, true)) {
    bool const is_short = pause_ * cycle_time_.seconds() < shortest_pause_s;
    if (!moves_.empty() && is_short) refuse(MoveProblemKind::short_pause, stop_line_);
    moves_.push_back({.begin = position_, .blocks = {}});
  }
  moves_.back().blocks.push_back(block);
  position_ = block.end;
  if (block.exact_stop) stop(0, block.line);
}

void ProgramMoves::command(motion::FilterChange const& change) {
  refuse(MoveProblemKind::filter_command, change.line);
}

void ProgramMoves::stop(double cycles, std::uint32_t line) {
  if (std::exchange(is_moving_, false)) {
    pause_ = 0;
    stop_line_ = line;
  }
  pause_ += cycles;
}

MotionKeys acting_keys(Move const& move, motion::PathDynamics const& dynamics) {
  using machine::Slope;
  MotionKeys keys;
  auto const set = [&keys](MotionKey key) { keys.set(index_of(key)); };
  bool const has_junctions = move.blocks.size() > 1;
  set(MotionKey::cycles);
  if (has_junctions) {
    set(MotionKey::corner);
    if (dynamics.channel.transition_mode == 0) set(MotionKey::weights);
  }
  auto from = move.begin;
  for (auto const& block : move.blocks) {
    auto const slope = block.dynamics ? block.dynamics->slope : dynamics.channel.slope;
    auto const way = motion::minus(block.end, std::exchange(from, block.end));
    auto const moving = std::count_if(way.begin(), way.end(), [](double each) { return each != 0; });
    if (block.arc) set(MotionKey::circle);
    if (slope == Slope::sin2) set(MotionKey::sine);
    if (slope != Slope::step && (moving > 1 || block.arc)) set(MotionKey::projection);
    if (!has_junctions) continue;
    if (slope == Slope::hsc) set(MotionKey::hsc);
    if (slope == Slope::trapez || slope == Slope::sin2) set(MotionKey::borders);
  }
  return keys;
}

}  // namespace axisc::comparison
