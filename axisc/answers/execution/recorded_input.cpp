#include "axisc/answers/execution/recorded_input.hpp"

#include "axisc/answers/execution/recorded_switches.hpp"
#include "axisc/answers/execution/timed_commands.hpp"

#include <utility>

namespace axisc {

RecordedInput recorded_input(RecordedQuestion const& question, InputImage const& input) {
  auto const& contents = input.image.contents;
  RecordedMachine const machine{.path = question.input,
                                .image = contents,
                                .machine = input.machine ? &input.machine->machine : nullptr};
  auto const recording = open_recording(question.recording);
  auto const axis = recorded_axis(machine, question.axis ? question.axis : input.axis(), recording);
  auto const commands =
      read_timed_commands(question.commands, input.image, question.input, question.language);
  auto recorded = compare_axis(machine, axis, recording, question.columns, question.units,
                               kernel_switches(commands, contents, axis, question.input));
  refuse_late(commands, recorded.columns.recording.input.size());
  return {.axis = axis, .recorded = std::move(recorded)};
}

}  // namespace axisc
