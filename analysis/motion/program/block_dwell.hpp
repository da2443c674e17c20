// G04: how long a block waits.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/state.hpp"

#include <optional>

namespace axisc::motion {

class BlockDwell {
 public:
  /// Both outlive this.
  BlockDwell(NcBlock const& block, ProgramState& state) : block_(block), state_(state) {}

  /// The word G04: from here on, numbers in the block are not positions.
  void begin(Token const& word) { word_ = word; }
  [[nodiscard]] bool is_open() const { return word_.has_value(); }
  [[nodiscard]] bool has_time() const { return seconds_.has_value(); }
  /// A second number is refused.
  void take(Token const& token, double seconds);
  /// After the last word: the path stops for the dwell time. A G04 without a number is refused.
  void finish();

 private:
  NcBlock const& block_;
  ProgramState& state_;
  std::optional<Token> word_;
  std::optional<double> seconds_;
};

}  // namespace axisc::motion
