#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

namespace axisc::validator::checks::ax5004::says {

constexpr Sentence headline{
    "#FILTER must not be used while an axis list activates the Vibration Guard: {axes}",
    "#FILTER darf nicht verwendet werden, wenn eine Achsliste den Vibration Guard aktiviert: {axes}"};
constexpr Sentence active_here{"activated here for axis {axis}", "hier für die Achse {axis} aktiviert"};
constexpr Sentence reaction{"the Vibration Guard is switched off", "der Vibration Guard wird abgeschaltet"};
constexpr Sentence help{
    "set `vib_guard.active 0`, or enable the FIR filters in the lists and remove #FILTER",
    "`vib_guard.active 0` setzen, oder die FIR-Filter in den Listen einschalten und auf #FILTER verzichten"};

}  // namespace axisc::validator::checks::ax5004::says

namespace axisc::validator::checks::ax5004 {
namespace {

void filter_with_guard_in_list(ProgramContext const& context, Report& report) {
  constexpr std::string_view active = "vib_guard.active";
  auto const axes =
      axes_where(context, [&](EffectiveValues const& values) { return values.at(active).value.flag(); });
  std::vector<Span> const spans = commands_where(context, [](grammar::NcCommand const& command) {
    return command.kind == grammar::CommandKind::filter;
  });
  if (axes.empty() || spans.empty()) return;
  Finding& finding =
      report_at_last(context, report, spans, message(says::headline, {{"axes", names_of(axes)}}));
  set_axis(finding, axes);
  relate_values(finding, axes, active, says::active_here);
  finding.help.push_back(message(says::help));
  set_reaction(finding, says::reaction);
}

}  // namespace

extern constinit Rule const rule{
    .control = "50987",
    .parameters = "vib_guard.active",
    .program_check = filter_with_guard_in_list,
};

}  // namespace axisc::validator::checks::ax5004
