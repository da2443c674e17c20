// `axisc simulate --program`: an NC program through planner and runtime.
#pragma once

#include "cli/commands/commands.hpp"
#include "cli/files/path_machine.hpp"
#include "cli/files/program_lines.hpp"
#include "motion/simulation.hpp"

#include <cstdint>
#include <functional>
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
  std::uint64_t most_cycles = motion::SimulationLimits{}.most_cycles;
  bool show_progress = false;
  bool color = false;
};

/// Takes what is wrong with a program, or not followed in it, as `lint` prints findings.
using ProblemSink = std::function<void(std::string const&)>;
[[nodiscard]] ProblemSink to_standard_error(Invocation const& invocation);

/// Reads the program once without moving anything and adds what its #FILTER commands need to the group's filter_sets.
/// False after mistakes.
[[nodiscard]] bool survey_program(ProgramLines& program, ProgramRequest const& request,
                                  machine::Machine& machine, std::size_t group, Language language,
                                  ProblemSink const& problems);

struct FollowedProgram {
  std::uint64_t blocks = 0, cycles = 0;
};

/// Follows a program that survey_program() accepted. Failure where the runtime refuses a step or a command.
[[nodiscard]] FollowedProgram follow_program(ProgramLines& program, ProgramRequest const& request,
                                             machine::Machine const& machine, std::size_t index,
                                             motion::SimulationListener& listener, Language language);

[[nodiscard]] ExitStatus simulate_program(ProgramRequest const& request, CheckedMachine checked,
                                          Invocation const& invocation);

}  // namespace axisc::cli
