// `axisc simulate --program`.
#pragma once

#include "cli/commands/commands.hpp"
#include "cli/execution/followed_program.hpp"
#include "cli/files/path_machine.hpp"
#include "cli/formats/simulate_formats.hpp"

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
