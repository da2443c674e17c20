// Helpers for the checks of AX5.
#pragma once

#include "validator/engine/rule.hpp"

#include <string>
#include <vector>

namespace axisc::validator {

/// True for a `#FILTER` that applies to FIR filters: one without [HSC].
[[nodiscard]] bool is_fir_filter(ProgramContext const& context, grammar::NcCommand const& command);
/// True for a `#FILTER ON` that applies to FIR filters.
[[nodiscard]] bool is_fir_filter_on(ProgramContext const& context, grammar::NcCommand const& command);

/// True for `#VIB GUARD ON`.
[[nodiscard]] inline bool is_guard_on(grammar::NcCommand const& command) {
  return command.kind == grammar::CommandKind::vibration_guard &&
         command.command_switch == grammar::CommandSwitch::on;
}

/// The names of the program's commands that `wanted` selects.
template <typename Wanted>
[[nodiscard]] std::vector<Span> commands_where(ProgramContext const& context, Wanted wanted) {
  std::vector<Span> spans;
  for (grammar::NcCommand const& command : context.program.tree.commands) {
    if (wanted(command)) spans.push_back(command.name);
  }
  return spans;
}

/// One finding at the last of `spans`; the others are related places, limited to the last ones. `spans` is
/// not empty and in the order of the text.
Finding& report_at_last(ProgramContext const& context, Report& report, std::vector<Span> const& spans,
                        Message message);

/// The axes of the channel that `wanted` selects; none for a program that no channel runs.
template <typename Wanted>
[[nodiscard]] std::vector<LoadedAxis const*> axes_where(ProgramContext const& context, Wanted wanted) {
  std::vector<LoadedAxis const*> axes;
  if (context.group == nullptr) return axes;
  for (std::size_t const index : context.group->axes) {
    LoadedAxis const& axis = context.whole.machine.axes[index];
    if (wanted(axis.merged.values)) axes.push_back(&axis);
  }
  return axes;
}

/// "X, Y".
[[nodiscard]] std::string names_of(std::vector<LoadedAxis const*> const& axes);

/// Sets the finding's axis if there is only one.
void set_axis(Finding& finding, std::vector<LoadedAxis const*> const& axes);

/// Relates the places where the axes' lists set a parameter.
void relate_values(Finding& finding, std::vector<LoadedAxis const*> const& axes, std::string_view pattern,
                   SentenceRef text);

}  // namespace axisc::validator
