#include "axisc/answers/machine/machine_answer.hpp"
#include "axisc/checking/checking_options.hpp"
#include "axisc/checking/machine_input.hpp"
#include "axisc/workspace/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/answer_output.hpp"

#include <algorithm>

namespace axisc::cli::says {

constexpr Sentence argument_machine{"a folder, a start-up list, a TwinCAT project, a machine file, or a list",
                                    "ein Ordner, eine Hochlaufliste, ein TwinCAT-Projekt, eine "
                                    "Maschinendatei oder eine Liste"};
constexpr Sentence lists_in_project{
    "the lists of {file} are inside the project, and a machine file can only name files; give the project "
    "itself, which every command takes that takes a machine file",
    "die Listen von {file} stehen im Projekt, und eine Maschinendatei kann nur Dateien nennen; das Projekt "
    "selbst angeben, das jeder Befehl anstelle einer Maschinendatei nimmt"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus machine(Invocation const& invocation) {
  std::optional<std::string> input;
  std::optional<std::string> cycle_time;
  auto format = presentation::Format::text;
  CommandLine command_line("machine", invocation.language);
  command_line.argument("INPUT", input, says::argument_machine);
  command_line.value("--cycle-time", "TIME", cycle_time, says::option_cycle_time);
  declare_format(command_line, format);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(input.has_value(), "INPUT");
  auto const path = machine_input(*input);
  Workspace workspace(overrides_with(cycle_time));
  SourceSet sources;
  auto const machine = loaded_machine(workspace, path, sources);
  bool const is_project = std::any_of(machine.lists.begin(), machine.lists.end(), [&](auto const& named) {
    return sources[named.list.source].is_window();
  });
  if (is_project && format == presentation::Format::json) {
    throw Failure({says::lists_in_project, {{"file", path}}});
  }
  bool const is_read_by_programs =
      format == presentation::Format::json || format == presentation::Format::csv;
  for (auto const& [place, reason] :
       is_read_by_programs ? lacks_of(machine, sources) : std::vector<MachineLack>()) {
    invocation.streams.err.write(place + ": " + text_of(reason, invocation.language) + "\n");
  }
  print(machine_answer(machine, sources), format, invocation, command_line);
  bool const is_understood = machine.complete && machine.findings.empty();
  return is_understood ? ExitStatus::success : ExitStatus::findings;
}

}  // namespace axisc::cli
