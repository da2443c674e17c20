// `axisc simulate --program`: an NC program through planner and runtime.
#pragma once

#include "cli/commands/commands.hpp"
#include "cli/files/path_machine.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace axisc::cli {

enum class SimulateFormat : std::uint8_t { text, csv, json };

struct ProgramRequest {
  std::string machine_path;
  std::string program_path;
  std::optional<std::string> group;
  std::optional<std::string> output;
  SimulateFormat format = SimulateFormat::text;
  bool constant_velocity = false;
  bool show_progress = false;
  bool color = false;
};

[[nodiscard]] ExitStatus simulate_program(ProgramRequest const& request, CheckedMachine checked,
                                          Invocation const& invocation);

}  // namespace axisc::cli
