#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/settings/settings.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/output/answer_output.hpp"

namespace axisc::cli::says {

constexpr Sentence argument_subject{
    "a code (AX3005), its name, a number (P-AXIS-00140), a parameter (filter[0].order), a part of one, a "
    "message number of the control, or a word of NC programs (G60, #SLOPE)",
    "ein Code (AX3005), sein Name, eine Nummer (P-AXIS-00140), ein Parameter (filter[0].order), ein Teil "
    "davon, eine Meldungsnummer der Steuerung oder ein Wort von NC-Programmen (G60, #SLOPE)"};
constexpr Sentence option_all{"every code in one Markdown document", "alle Codes in einem Markdown-Dokument"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus explain(Invocation const& invocation) {
  std::optional<std::string> word;
  bool all = false;
  auto format = presentation::Format::markdown;
  CommandLine command_line("explain", invocation.language);
  command_line.argument("CODE|P-AXIS-NNNNN|PARAMETER|MESSAGE|WORD", word, says::argument_subject);
  command_line.flag("--all", all, says::option_all);
  declare_format(command_line, format);
  std::vector<std::string> schema_files;
  declare_schema(command_line, schema_files);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(word || all, "CODE|P-AXIS-NNNNN|PARAMETER|MESSAGE|WORD");
  // The parameters that lists of the working folder may set.
  ExplainQuestion const question{
      .word = word.value_or(""), .all = all, .of_axes = SettingsFinder(schema_files).catalogue("-")};
  print(explain_answer(question), format, invocation, command_line);
  return ExitStatus::success;
}

}  // namespace axisc::cli
