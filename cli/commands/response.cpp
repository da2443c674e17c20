#include "axisc/answers/execution/response_answer.hpp"
#include "axisc/asked/frequencies.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/command_line.hpp"
#include "cli/output/answer_output.hpp"

namespace axisc::cli::says {

constexpr Sentence option_axis{"only this axis (default: all)", "nur diese Achse (Standardwert: alle)"};
constexpr Sentence option_port{"which chain (default: setpoint)",
                               "welche Filterkette (Standardwert: setpoint)"};
constexpr Sentence option_frequencies{
    "in Hz, from 0 to 0.5/T (default: 200 logarithmic points up to 0.5/T, and the frequencies of the "
    "filters)",
    "in Hz, von 0 bis 0,5/T (Standardwert: 200 logarithmische Punkte bis 0,5/T und die Frequenzen der "
    "Filter)"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus response(Invocation const& invocation) {
  std::optional<std::string> path, frequencies, level;
  std::vector<std::string> commands;
  ResponseQuestion question;
  auto format = presentation::Format::csv;
  CommandLine command_line("response", invocation.language);
  command_line.argument("IMAGE.axim", path, says::argument_image);
  command_line.value("--axis", "NAME", question.axis, says::option_axis);
  command_line.choice(
      "--port", {{"setpoint", Port::setpoint}, {"interface", Port::interface}, {"velocity", Port::velocity}},
      question.port, says::option_port);
  command_line.value("--frequencies", "F[,F...]", frequencies, says::option_frequencies);
  command_line.value("--level", level_names, level, says::option_level);
  command_line.values("--at", "CYCLE:COMMAND", commands, says::option_at);
  declare_format(command_line, format);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(path.has_value(), "IMAGE.axim");
  auto const file = load_image(*path);
  question.image = *path;
  question.level = level_of(level);
  if (frequencies) question.frequencies = parse_frequencies(*frequencies, file.contents.cycle_time);
  question.commands = read_timed_commands(commands, file, *path, invocation.language);
  print(response_answer(question, file), format, invocation, command_line);
  return ExitStatus::success;
}

}  // namespace axisc::cli
