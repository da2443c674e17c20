// Where a block goes: its coordinates and its circle, as the path follows them.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/state.hpp"

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string_view>

namespace axisc::motion {

/// One block's motion. Words that cannot be followed are refused.
class BlockMotion {
 public:
  BlockMotion(NcBlock const& block, ProgramState& state);

  void set_label(std::string_view label) { next_.label = label; }
  /// Value in the program's unit.
  void take_coordinate(Token const& token, std::size_t axis, double value);
  /// I, J, K or R, in the program's unit.
  void take_arc_word(Token const& token, char letter, double value);
  /// F, in the program's unit.
  void take_feed(Token const& token, double value);
  /// S: counts with G95 only.
  void take_speed(Token const& token, double value);
  /// G60: the path stops at the end of the block.
  void stop_at_end(Token const& word) { stop_ = word; }
  /// G09: the path has slowed down by the end of the block, whatever G901 says.
  void brake_in_time() { brakes_in_time_ = true; }
  /// G61: the control rounds the corner at the end of the block.
  void round_corner() { rounds_corner_ = true; }
  /// After the last word: a stop without motion is refused.
  void finish();
  /// Words since the last move() give a destination.
  [[nodiscard]] bool moves() const { return moves_; }
  /// Passes the motion of the words so far to the listener.
  void move();

 private:
  [[nodiscard]] double feed();
  [[nodiscard]] bool make_arc();
  [[nodiscard]] bool asks_for_arc() const;

  NcBlock const& block_;
  ProgramState& state_;
  ProgrammedBlock next_;
  bool moves_ = false;
  std::bitset<most_axes> moved_;                    ///< axes that were named
  std::array<std::optional<double>, 3> to_center_;  ///< I, J, K, position units
  std::optional<double> radius_;                    ///< R
  bool feed_named_ = false, speed_named_ = false;
  Token first_coordinate_, first_arc_word_;
  std::optional<Token> stop_;
  bool brakes_in_time_ = false, rounds_corner_ = false;
  bool has_moved_ = false;
};

}  // namespace axisc::motion
