#include "validator/engine/rule.hpp"

#include "validator/commands/command_keywords.hpp"
#include "validator/commands/command_mistake.hpp"
#include "validator/rules/command_mistakes.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

namespace axisc::validator::checks::ax3026::says {

constexpr Sentence headline{
    "with a damping of 1 there is no oscillation that the Vibration Guard could shape",
    "mit einer Dämpfung von 1 gibt es keine Schwingung, die der Vibration Guard formen könnte"};
constexpr Sentence of_command{
    "the command takes the damping of the lists, which is 1 for {axes}: there is no oscillation to shape",
    "der Befehl nimmt die Dämpfung der Listen, die für {axes} 1 ist: es gibt keine Schwingung zu formen"};
constexpr Sentence damping_here{"the damping is set here", "hier wird die Dämpfung gesetzt"};
constexpr Sentence measure{"enter the measured damping ratio of the mechanics; the default is 0.1",
                           "das gemessene Dämpfungsmaß der Mechanik eintragen; der Standardwert ist 0,1"};

}  // namespace axisc::validator::checks::ax3026::says

namespace axisc::validator::checks::ax3026 {
namespace {

bool is_one(GuardView const& guard) {
  return !guard.damping.unusable && guard.damping.value.number == 1;
}

void guard_without_oscillation(AxisContext const& axis, Report& report) {
  if (!axis.guard.is_active() || !is_one(axis.guard)) return;
  Finding& finding = report.add(axis.guard.anchor(axis.guard.damping), {says::headline, {}});
  finding.help.push_back({says::measure, {}});
  react(finding, {validator::says::guard_stops_motion, {}});
}

void in_command(CommandContext const& context, Report& report) {
  report_mistakes(context, without_oscillation, report);
}

/// Commands that leave the damping to the lists; those that activate a guard themselves are reported there.
void in_program(ProgramContext const& context, Report& report) {
  auto const axes = axes_where(context, [](EffectiveValues const& values) {
    GuardView const guard(values);
    return is_one(guard) && !guard.is_active();
  });
  auto const spans = commands_where(context, [&](grammar::NcCommand const& command) {
    return is_guard_on(command) && find_keyword(command, context.text, "DAMPING") == nullptr;
  });
  if (axes.empty() || spans.empty()) return;
  Finding& finding =
      report_at_last(context, report, spans, message(says::of_command, {{"axes", names_of(axes)}}));
  set_axis(finding, axes);
  relate_values(finding, axes, "vib_guard.damping", says::damping_here);
  finding.help.push_back(message(says::measure));
  set_reaction(finding, validator::says::guard_stops_motion);
}

}  // namespace

extern constinit Rule const rule{
    .control = no_guard,
    .parameters = "vib_guard.active vib_guard.damping",
    .check = guard_without_oscillation,
    .program_check = in_program,
    .command_check = in_command,
};

}  // namespace axisc::validator::checks::ax3026
