#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/settings/settings.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/output/answer_output.hpp"
#include "diagnostics/joined.hpp"

#include <string>
#include <vector>

namespace axisc::cli::says {

constexpr Sentence argument_subject{
    "what you look for: a code (AX3005), a number (P-AXIS-00140), a parameter or a part of one, a message of "
    "the control (\"error 50663\"), a word of NC programs (G60, #FILTER), or words (\"notch filter\")",
    "was gesucht wird: ein Code (AX3005), eine Nummer (P-AXIS-00140), ein Parameter oder ein Teil davon, "
    "eine Meldung der Steuerung („Fehler 50663“), ein Wort von NC-Programmen (G60, #FILTER) oder Wörter "
    "(Kerbfilter)"};
constexpr Sentence option_all_codes{"every code in one Markdown document",
                                    "alle Codes in einem Markdown-Dokument"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus explain(Invocation const& invocation) {
  std::vector<std::string> words;
  bool all = false;
  auto format = presentation::Format::markdown;
  CommandLine command_line("explain", invocation.language);
  command_line.arguments("WORDS", words, says::argument_subject);
  command_line.flag("--all", all, says::option_all_codes);
  declare_format(command_line, format);
  std::vector<std::string> schema_files;
  declare_schema(command_line, schema_files);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(!words.empty() || all, "WORDS");
  // The parameters that lists of the working folder may set.
  ExplainQuestion const question{
      .word = joined(words, " "), .all = all, .of_axes = SettingsFinder(schema_files).catalogue("-")};
  print(explain_answer(question), format, invocation, command_line);
  return ExitStatus::success;
}

}  // namespace axisc::cli
