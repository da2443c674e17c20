// AX2016: commands and keywords that the control's build does not know yet.
#include "validator/build_version.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/program_checks.hpp"
#include "validator/rules/program_helpers.hpp"

#include <algorithm>

namespace axisc::validator::checks {
namespace {

/// `#FILTER OFF` ends what the program switched on: the HSC filters alone where it switches no others on.
bool meant_for_fir(ProgramContext const& context, grammar::NcCommand const& command) {
  if (!is_fir_filter(context, command)) return false;
  if (command.command_switch != grammar::CommandSwitch::off) return true;
  bool uses_hsc = false;
  for (grammar::NcCommand const& other : context.program.tree.commands) {
    if (other.kind != grammar::CommandKind::filter || other.command_switch == grammar::CommandSwitch::off) {
      continue;
    }
    if (is_fir_filter(context, other)) return true;
    uses_hsc = true;
  }
  return !uses_hsc;
}

void check_needed(ProgramContext const& context, Span span, BuildVersion const& needed, Report& report) {
  BuildVersion const& build = *context.whole.machine.build;
  if (build >= needed) return;
  std::string const written(context.text.substr(span.begin, span.size()));
  report.add(Place{.source = context.program.source, .span = span},
             message(Text::ax2016,
                     {{"parameter", written}, {"needed", to_text(needed)}, {"build", to_text(build)}}));
}

}  // namespace

void commands_newer_than_build(ProgramContext const& context, Report& report) {
  if (!context.whole.machine.build) return;
  BuildVersion const& build = *context.whole.machine.build;
  for (grammar::NcCommand const& command : context.program.tree.commands) {
    if (command.kind == grammar::CommandKind::vibration_guard) {
      check_needed(context, command.name, builds::fir, report);
    } else if (meant_for_fir(context, command)) {
      check_needed(context, command.name, builds::fir_command, report);
      // A build that does not know the command is told once.
      grammar::Keyword const* const quality = find_keyword(command, context.text, "QUALITY");
      if (quality == nullptr || build < builds::fir_command) continue;
      check_needed(context, quality->name, builds::fir_quality, report);
    }
  }
}

}  // namespace axisc::validator::checks
