// `axisc simulate --program`.
#pragma once

#include "axisc/answers/simulation/followed_program.hpp"
#include "axisc/answers/simulation/simulate_formats.hpp"
#include "axisc/checking/path_machine.hpp"
#include "cli/commands/commands.hpp"

#include <optional>
#include <string>

namespace axisc::cli {

struct SimulatedProgram {
  ProgramRequest request;
  std::optional<std::string> group;
  std::optional<std::string> output;
  SimulateFormat format = SimulateFormat::text;
  bool show_progress = false;
  bool color = false;
};

[[nodiscard]] ExitStatus simulate_program(SimulatedProgram const& asked, CheckedMachine checked,
                                          Invocation const& invocation);

}  // namespace axisc::cli
