// The parameters of a program, P1 and V.P.NAME, and the expressions that they are in.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/problems.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::motion {

/// P1, V.P.NAME.
[[nodiscard]] bool is_variable(std::string_view name);

class ProgramVariables {
 public:
  /// Where to find it; 0 at first.
  [[nodiscard]] double& operator[](std::string const& name) { return values_[name]; }

  /// The value of the expression at a place of the program, which is moved past it; nothing where it was
  /// refused, with `token` as its place.
  [[nodiscard]] std::optional<double> value_at(std::uint32_t& place, NcBlock const& block, Token const& token,
                                               ProgramProblems& problems) const;
  /// The value of the expression that is the rest of the block after that word; 0 where it was refused.
  [[nodiscard]] double value_behind(std::size_t at, NcBlock const& block, ProgramProblems& problems) const;

 private:
  std::map<std::string, double, std::less<>> values_;
};

}  // namespace axisc::motion
