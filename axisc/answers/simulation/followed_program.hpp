// An NC program through planner and runtime.
#pragma once

#include "analysis/motion/program/interpreter.hpp"
#include "analysis/motion/simulation.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/program_lines.hpp"
#include "configuration/machine/machine.hpp"
#include "diagnostics/finding.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace axisc {

struct ProgramRequest {
  std::string machine_path;
  std::string program_path;
  bool constant_velocity = false;
  bool sharp_corners = false;  ///< corners that the control rounds are followed as they are
  std::uint64_t most_cycles = motion::SimulationLimits{}.most_cycles;
  /// Called now and then: the share of the program that has been read, and the seconds of machine time.
  std::function<void(double share, double seconds)> working = {};
};

/// The channel that the group is, as programs see it.
[[nodiscard]] motion::ProgramChannel channel_of(machine::Machine const& machine,
                                                machine::MachineGroup const& group);

/// What lists and settings say about its path.
[[nodiscard]] motion::PathDynamics path_dynamics(machine::Machine const& machine,
                                                 machine::MachineGroup const& group);

/// Takes what is wrong with a program, or not followed in it.
using TakeProblem = std::function<void(Finding const& problem, SourceSet const& sources)>;

/// Reads the program once without moving anything and adds what its #FILTER commands need to the group's
/// filter_sets. False after mistakes.
[[nodiscard]] bool survey_program(ProgramLines& program, ProgramRequest const& request,
                                  machine::Machine& machine, std::size_t group, TakeProblem const& take);

struct FollowedProgram {
  std::uint64_t blocks = 0, cycles = 0;
  std::optional<double> rounding = std::nullopt;  ///< mm by which the control rounds corners at most
};

/// Follows a program that survey_program() accepted. Failure where the runtime refuses a step or a command.
[[nodiscard]] FollowedProgram follow_program(ProgramLines& program, ProgramRequest const& request,
                                             machine::Machine const& machine, std::size_t index,
                                             motion::SimulationListener& listener);

/// What is said of a pass that does not keep its tolerance.
[[nodiscard]] Failure not_kept(motion::PassSummary const& pass, std::string const& path);

}  // namespace axisc
