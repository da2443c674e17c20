// What a program asks of the path, block by block.
#pragma once

#include "analysis/motion/path_block.hpp"
#include "configuration/machine/filter_command.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace axisc::motion {

/// A #FILTER command.
struct FilterChange {
  machine::FilterCommand command;
  std::optional<double> tolerance;  ///< AX_DEV in position units
  std::string text;                 ///< as the program writes it, blanks and comments around it left out
  std::uint32_t line = 0;
};

class PathListener {
 public:
  virtual ~PathListener() = default;
  virtual void motion(ProgrammedBlock const& block) = 0;
  virtual void command(FilterChange const& change) = 0;
  /// The path stops here, as `line` of the program says; it goes on when the filters have settled, and after so many cycles
  /// at the earliest.
  virtual void stop(double /*cycles*/, std::uint32_t /*line*/) {}
  virtual void end() = 0;

 protected:
  PathListener() = default;
  PathListener(PathListener const&) = default;
  PathListener& operator=(PathListener const&) = default;
};

}  // namespace axisc::motion
