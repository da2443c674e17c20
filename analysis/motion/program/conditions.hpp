// The conditions of a program that are open: $IF, $ELSEIF, $ELSE, $ENDIF.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/problems.hpp"
#include "analysis/motion/program/variables.hpp"

#include <cstddef>
#include <vector>

namespace axisc::motion {

class ProgramConditions {
 public:
  /// Both outlive this.
  ProgramConditions(ProgramVariables const& variables, ProgramProblems& problems)
      : variables_(variables), problems_(problems) {}

  /// False where the block does not belong to a condition.
  bool take(NcBlock const& block);
  /// The next block is executed.
  [[nodiscard]] bool is_active() const { return open_.empty() || open_.back().holds; }
  [[nodiscard]] std::size_t open_count() const { return open_.size(); }
  /// The innermost one lacks its $ENDIF.
  void refuse_open();
  /// Forgets those opened since there were this many.
  void close_to(std::size_t count);

 private:
  struct Condition {
    bool holds = false;  ///< the blocks that follow are executed
    bool held = false;   ///< this branch or an earlier one
    KeptBlock opening;
  };

  void open(NcBlock const& block, std::size_t at);

  ProgramVariables const& variables_;
  ProgramProblems& problems_;
  std::vector<Condition> open_;
};

}  // namespace axisc::motion
