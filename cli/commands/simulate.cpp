#include "cli/options/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/path_machine.hpp"
#include "cli/report/progress.hpp"
#include "cli/commands/simulate_plant.hpp"
#include "cli/commands/simulate_program.hpp"

namespace axisc::cli {

namespace {

struct SimulateWords {
  std::optional<std::string> machine, program, output, group, cycle_time, plant, move;
  SimulateForm form = SimulateForm::text;
  bool constant_velocity = false;
  bool progress = false;
  bool no_progress = false;
};

void declare(CommandLine& command_line, SimulateWords& words) {
  command_line.argument("MACHINE", words.machine, Text::cli_arg_input);
  command_line.value("--program", "PART.nc", words.program, Text::cli_opt_simulate_program);
  command_line.value("-o,--output", "FILE.csv", words.output, Text::cli_opt_simulate_output);
  command_line.value("--group", "NAME", words.group, Text::cli_opt_group);
  command_line.flag("--constant-velocity", words.constant_velocity, Text::cli_opt_constant_velocity);
  command_line.value("--plant", "PLANT.json", words.plant, Text::cli_opt_plant);
  command_line.value("--move", "AXIS:MM[:F]", words.move, Text::cli_opt_move);
  command_line.value("--cycle-time", "TIME", words.cycle_time, Text::cli_opt_cycle_time);
  command_line.choice(
      "--format", {{"text", SimulateForm::text}, {"csv", SimulateForm::csv}, {"json", SimulateForm::json}},
      words.form, Text::cli_opt_simulate_format);
  command_line.flag("--progress", words.progress, Text::cli_opt_progress);
  command_line.flag("--no-progress", words.no_progress, Text::cli_opt_no_progress);
}

}  // namespace

ExitStatus simulate(Invocation const& invocation) {
  SimulateWords words;
  CommandLine command_line("simulate", Text::cli_simulate_purpose, Text::cli_simulate_examples,
                           invocation.language);
  declare(command_line, words);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(words.machine.has_value(), "MACHINE");
  bool const closed_loop = words.plant && words.move;
  if (words.program.has_value() == closed_loop || words.plant.has_value() != words.move.has_value()) {
    throw Failure({.text = Text::cli_simulate_what, .arguments = {}});
  }
  bool const color = use_color(command_line.color(), system::Stream::error);
  auto checked = checked_machine(*words.machine, words.cycle_time, invocation, color);
  if (!checked) return ExitStatus::findings;
  if (closed_loop) {
    return simulate_plant({.machine_path = *words.machine,
                           .plant_path = *words.plant,
                           .move = *words.move,
                           .output = words.output,
                           .form = words.form},
                          *checked, invocation);
  }
  return simulate_program({.machine_path = *words.machine,
                           .program_path = *words.program,
                           .group = words.group,
                           .output = words.output,
                           .form = words.form,
                           .constant_velocity = words.constant_velocity,
                           .show_progress = words.progress || (!words.no_progress && progress_is_seen()),
                           .color = color},
                          *std::move(checked), invocation);
}

}  // namespace axisc::cli
