// The loops of a program: $FOR, $WHILE, $REPEAT.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/problems.hpp"
#include "analysis/motion/program/variables.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace axisc::motion {

[[nodiscard]] bool opens_loop(std::string_view control);
[[nodiscard]] bool closes_loop(std::string_view control);

/// How many blocks a loop has, from the one that opens it to the one that closes it; nothing where it stays
/// open.
[[nodiscard]] std::size_t loop_size(KeptBlocks blocks);

/// The blocks that open and close a loop decide whether it continues.
class LoopRounds {
 public:
  /// All must outlive this.
  LoopRounds(NcBlock const& opening, NcBlock const& closing, ProgramVariables& variables,
             ProgramProblems& problems)
      : opening_(opening), closing_(closing), variables_(variables), problems_(problems) {}

  /// Refuses an end that belongs to another kind of loop.
  void check();
  /// Before each round; false where the loop is over or its condition was refused.
  [[nodiscard]] bool begins();
  /// After each round.
  [[nodiscard]] bool goes_on();

 private:
  [[nodiscard]] bool count(std::size_t at);

  NcBlock const& opening_;
  NcBlock const& closing_;
  ProgramVariables& variables_;
  ProgramProblems& problems_;
  bool is_first_ = true;
};

}  // namespace axisc::motion
