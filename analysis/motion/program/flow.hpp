// The order in which a program's blocks are executed.
//
// Blocks are executed as they come and forgotten, except those of subprograms and of the open loop.
#pragma once

#include "analysis/motion/program/conditions.hpp"
#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/state.hpp"
#include "analysis/motion/program/subprograms.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace axisc::motion {

class ProgramFlow {
 public:
  /// Must outlive this.
  explicit ProgramFlow(ProgramState& state)
      : state_(state), subprograms_(state.problems), conditions_(state.variables, state.problems) {}

  /// The block that was read last: executed, or kept for later.
  void next(NcBlock const& block);
  /// After the last block: anything still open is refused.
  void finish();

 private:
  /// Why execution leaves the blocks of a loop or subprogram.
  enum class Leaves : std::uint8_t { nothing, round, loop, subprogram };

  bool keep_in_loop(NcBlock const& block);
  void execute(NcBlock const& block);
  void take_control(NcBlock const& block);
  void call(NcBlock const& block, std::size_t at);
  void run(KeptBlocks blocks);
  void run_loop(KeptBlocks loop);
  void repeat(NcBlock const& block);
  void count_repeated(NcBlock const& block);
  [[nodiscard]] bool goes_on() const { return !state_.ended && !state_.problems.broken(); }
  void refuse(NcBlock const& block, SentenceRef text);

  ProgramState& state_;
  ProgramSubprograms subprograms_;
  ProgramConditions conditions_;
  std::vector<KeptBlock> loop_;  ///< that is being read
  int loop_depth_ = 0;
  Leaves leaves_ = Leaves::nothing;
  int depth_ = 0;  ///< of loops and subprograms that are executed
  int calls_ = 0;  ///< subprograms that are executed
  int loops_ = 0;  ///< that are executed in the innermost of them
  std::uint64_t repeated_ = 0;
};

}  // namespace axisc::motion
