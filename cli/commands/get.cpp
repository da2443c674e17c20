#include "axisc/answers/values/values_answer.hpp"
#include "axisc/checking/checking_options.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/answer_output.hpp"

namespace axisc::cli::says {

constexpr Sentence argument_values{
    "a machine or a list; an axis, which may be left out for a list; names, numbers or words of parameters",
    "eine Maschine oder eine Liste; eine Achse, die bei einer Liste fehlen darf; Namen, Nummern oder Wörter "
    "für Parameter"};
constexpr Sentence option_all_values{"every parameter that a list sets",
                                     "alle Parameter, die eine Liste setzt"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus get(Invocation const& invocation) {
  std::vector<std::string> words;
  ValuesQuestion question;
  std::optional<std::string> cycle_time;
  std::vector<std::string> schema_files;
  auto format = presentation::Format::text;
  CommandLine command_line("get", invocation.language);
  command_line.arguments("INPUT AXIS PARAMETER...", words, says::argument_values);
  command_line.flag("--all", question.all, says::option_all_values);
  command_line.value("--cycle-time", "TIME", cycle_time, says::option_cycle_time);
  declare_format(command_line, format);
  declare_schema(command_line, schema_files);
  declare_alone(command_line, question.machine.alone);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(!words.empty(), "INPUT");
  question.machine.input = words.front();
  question.words.assign(words.begin() + 1, words.end());
  Workspace workspace(overrides_with(cycle_time, schema_files));
  print(values_answer(workspace, question), format, invocation, command_line);
  return ExitStatus::success;
}

}  // namespace axisc::cli
