#include "axisc/answers/suggestion/applied_suggestion.hpp"
#include "axisc/answers/values/set_values.hpp"
#include "axisc/checking/checking_options.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/printed_errors.hpp"

#include <algorithm>

namespace axisc::cli::says {

constexpr Sentence argument_assignments{
    "a machine or a list; an axis, which may be left out for a list; parameters with their values, also with "
    "units: filter[0].fg_f0=48Hz",
    "eine Maschine oder eine Liste; eine Achse, die bei einer Liste fehlen darf; Parameter mit ihren Werten, "
    "auch mit Einheiten: filter[0].fg_f0=48Hz"};
constexpr Sentence option_diff_values{"show the patch, write nothing", "den Patch zeigen, nichts schreiben"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus set(Invocation const& invocation) {
  std::vector<std::string> words;
  SetQuestion question;
  bool diff = false;
  std::optional<std::string> cycle_time;
  std::vector<std::string> schema_files;
  CommandLine command_line("set", invocation.language);
  command_line.arguments("INPUT AXIS PARAMETER=VALUE...", words, says::argument_assignments);
  command_line.flag("--diff", diff, says::option_diff_values);
  command_line.value("--cycle-time", "TIME", cycle_time, says::option_cycle_time);
  declare_schema(command_line, schema_files);
  declare_alone(command_line, question.machine.alone);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(!words.empty(), "INPUT");
  question.machine.input = words.front();
  question.words.assign(words.begin() + 1, words.end());
  Workspace workspace(overrides_with(cycle_time, schema_files));
  auto const made =
      set_values(workspace, question,
                 printed_errors(invocation, use_color(command_line.color(), system::Stream::error)));
  if (!made) return ExitStatus::findings;
  auto const& [edits, notes] = *made;
  if (diff) invocation.streams.out.write(patch_of(edits));
  std::for_each(notes.begin(), notes.end(), printed_notes(invocation));
  auto const done = diff ? notes_of(edits) : write_lists(edits);
  std::for_each(done.begin(), done.end(), printed_notes(invocation));
  return ExitStatus::success;
}

}  // namespace axisc::cli
