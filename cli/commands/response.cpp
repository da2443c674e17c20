#include "axisc/answers/execution/response_answer.hpp"
#include "axisc/asked/frequencies.hpp"
#include "axisc/checking/compiled_input.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/decimal_comma.hpp"
#include "cli/output/printed_errors.hpp"

namespace axisc::cli::says {

constexpr Sentence option_axis_of_response{"only this axis (default: all)",
                                           "nur diese Achse (Standardwert: alle)"};
constexpr Sentence option_port_of_response{"which chain (default: setpoint)",
                                           "welche Filterkette (Standardwert: setpoint)"};
constexpr Sentence option_frequencies{
    "in Hz, from 0 to 0.5/T (default: 200 logarithmic points up to 0.5/T, and the frequencies of the "
    "filters)",
    "in Hz, von 0 bis 0,5/T (Standardwert: 200 logarithmische Punkte bis 0,5/T und die Frequenzen der "
    "Filter)"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus response(Invocation const& invocation) {
  MachineRequest request;
  std::optional<std::string> path, cycle_time, frequencies, level;
  std::vector<std::string> commands;
  ResponseQuestion question;
  auto format = presentation::Format::csv;
  CommandLine command_line("response", invocation.language);
  command_line.argument("INPUT", path, says::argument_machine_or_image);
  command_line.value("--cycle-time", "TIME", cycle_time, says::option_cycle_time);
  declare_alone(command_line, request.alone);
  command_line.value("--axis", "NAME", question.axis, says::option_axis_of_response);
  command_line.choice("--port", ports, question.port, says::option_port_of_response);
  command_line.value("--frequencies", "F[,F...]", frequencies, says::option_frequencies);
  command_line.value("--level", level_names, level, says::option_level);
  command_line.values("--at", "CYCLE:COMMAND", commands, says::option_at);
  declare_format(command_line, format);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(path.has_value(), "INPUT");
  request.input = question.image = *path;
  remark_decimal_comma(invocation, "--frequencies", frequencies);
  Workspace workspace(overrides_with(cycle_time));
  auto const errors = printed_errors(invocation, use_color(command_line.color(), system::Stream::error));
  auto const input = compiled_input(workspace, request, errors);
  if (!input) return ExitStatus::findings;
  auto const& file = input->image;
  if (!question.axis) question.axis = input->axis();
  question.level = level_of(level);
  if (frequencies) question.frequencies = parse_frequencies(*frequencies, file.contents.cycle_time);
  question.commands = read_timed_commands(commands, file, *path, invocation.language);
  print(response_answer(question, file), format, invocation, command_line);
  return ExitStatus::success;
}

}  // namespace axisc::cli
