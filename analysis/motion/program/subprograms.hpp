// The subprograms that a program has in its own file, from %L NAME to M17 or M29.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/problems.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::motion {

class ProgramSubprograms {
 public:
  /// Must outlive this.
  explicit ProgramSubprograms(ProgramProblems& problems) : problems_(problems) {}

  /// `%L NAME` begins one, which may not be in a loop; %LENGTHS is a program, for which the answer is false.
  bool begin(NcBlock const& block, bool in_loop);
  /// False where the block does not belong to one.
  bool keep(NcBlock const& block);
  /// Null where there is none before this place. Valid until one begins.
  [[nodiscard]] std::vector<KeptBlock> const* find(std::string_view name) const;

  [[nodiscard]] bool is_open() const { return open_ != nullptr; }
  /// The open one does not end.
  void refuse_open();

 private:
  ProgramProblems& problems_;
  std::map<std::string, std::vector<KeptBlock>, std::less<>> blocks_;
  std::vector<KeptBlock>* open_ = nullptr;  ///< that is being read
  std::optional<KeptBlock> opening_;        ///< its %L
  int depth_ = 0;                           ///< of its loops and conditions
};

}  // namespace axisc::motion
