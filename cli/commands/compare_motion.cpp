#include "axisc/answers/comparison/motion_answer.hpp"
#include "axisc/answers/comparison/telling_text.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/files/recorded_positions.hpp"
#include "cli/commands/compare_options.hpp"
#include "cli/options/check_options.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/printed_errors.hpp"

#include <algorithm>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence no_motion_settings{
    "no settings: the recording tells no reading; `axisc compare` without --emit says what fits",
    "keine Einstellungen: Die Aufzeichnung ergibt keine Lesart; `axisc compare` ohne --emit nennt, was "
    "passt"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct ChosenGroup {
  CheckedMachine checked;
  std::size_t group = 0;
};

std::optional<CheckedMachine> checked(CompareOptions const& options, Invocation const& invocation,
                                      bool color) {
  Workspace workspace(overrides_with(options.cycle_time));
  return checked_machine(workspace, {.input = *options.input, .alone = options.alone},
                         printed_errors(invocation, color));
}

std::optional<ChosenGroup> chosen(CompareOptions const& options, Invocation const& invocation, bool color) {
  auto machine = checked(options, invocation, color);
  if (!machine) return std::nullopt;
  auto const group =
      chosen_group(machine->machine, options.group ? options.group : machine->group, *options.input);
  return ChosenGroup{.checked = *std::move(machine), .group = group};
}

ExitStatus emit_motion(comparison::MotionComparison const& result, Invocation const& invocation) {
  auto const open = motion_left_open(result);
  bool const is_complete = open.empty() && result.unexplained.empty();
  return emit_settings(motion_settings(result), open, is_complete || result.agrees(),
                       says::no_motion_settings, invocation);
}

}  // namespace

ExitStatus compare_motion(CompareOptions const& options, Invocation const& invocation,
                          CommandLine const& command_line) {
  bool const color = use_color(command_line.color(), system::Stream::error);
  auto const columns = axis_columns("--in", options.columns);
  auto made = chosen(options, invocation, color);
  if (!made) return ExitStatus::findings;
  auto& machine = made->checked.machine;
  ProgramRequest const request{.machine_path = *options.input, .program_path = *options.program};
  ProgramLines program(*options.program);
  if (!survey_program(program, request, machine, made->group, printed_problems(invocation, color))) {
    return ExitStatus::findings;
  }
  auto const recorded =
      compare_program(program, request, machine, made->group,
                      {.path = *options.recording, .columns = columns, .units = options.numbers.units()});
  if (options.emitted == Emitted::settings) return emit_motion(recorded.result, invocation);
  print(motion_answer(recorded), options.format, invocation, command_line);
  return recorded.result.agrees() ? ExitStatus::success : ExitStatus::findings;
}

ExitStatus emit_program(CompareOptions const& options, Invocation const& invocation,
                        CommandLine const& command_line) {
  auto const made = chosen(options, invocation, use_color(command_line.color(), system::Stream::error));
  if (!made) return ExitStatus::findings;
  invocation.streams.out.write(
      telling_text(made->checked.machine, made->group, *options.input, invocation.language));
  return ExitStatus::success;
}

ExitStatus emit_template(CompareOptions const& options, Invocation const& invocation,
                         CommandLine const& command_line) {
  auto const machine = checked(options, invocation, use_color(command_line.color(), system::Stream::error));
  if (!machine) return ExitStatus::findings;
  auto const axis = options.axis ? options.axis : machine->axis;
  auto const made = recording_template(
      {.machine = *options.input, .net_id = options.net_id, .axes = axis, .purpose = options.purpose},
      machine->machine, invocation.language);
  invocation.streams.out.write(made.text);
  std::for_each(made.notes.begin(), made.notes.end(), printed_notes(invocation));
  return ExitStatus::success;
}

}  // namespace axisc::cli
