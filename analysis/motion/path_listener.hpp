// Receives the path that a program describes, block by block.
#pragma once

#include "analysis/motion/path_block.hpp"
#include "configuration/machine/filter_command.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace axisc::motion {

/// A #FILTER or #VIB GUARD command.
struct FilterChange {
  machine::FilterCommand command;
  std::optional<double> tolerance;  ///< AX_DEV in position units
  std::string text;                 ///< as in the program, without blanks and comments around it
  std::uint32_t line = 0;
};

class PathListener {
 public:
  virtual ~PathListener() = default;
  virtual void motion(ProgrammedBlock const& block) = 0;
  virtual void command(FilterChange const& change) = 0;
  /// G135 or G137, on `line` of the program.
  virtual void feedforward(bool /*is_on*/, std::uint32_t /*line*/) {}
  /// The path stops here, on `line` of the program; it continues when the filters have settled, and after
  /// this many cycles at the earliest.
  virtual void stop(double /*cycles*/, std::uint32_t /*line*/) {}
  virtual void end() = 0;

 protected:
  PathListener() = default;
  PathListener(PathListener const&) = default;
  PathListener& operator=(PathListener const&) = default;
};

}  // namespace axisc::motion
