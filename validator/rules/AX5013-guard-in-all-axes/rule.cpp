#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax5013::says {

constexpr Sentence in_all{
    "`#VIB GUARD ON` switches the Vibration Guard on in all axes; the lists activate it for {axes} only",
    "`#VIB GUARD ON` schaltet den Vibration Guard in allen Achsen ein; die Listen aktivieren ihn nur für "
    "{axes}"};
constexpr Sentence active_here{"activated here for axis {axis}", "hier für die Achse {axis} aktiviert"};
constexpr Sentence reaction{"it says that the guard now acts in all axes",
                            "sie meldet, dass er nun in allen Achsen wirkt"};
constexpr Sentence help{"if only these axes are meant, leave `#VIB GUARD ON` out",
                        "sind nur diese Achsen gemeint, `#VIB GUARD ON` weglassen"};

}  // namespace axisc::validator::checks::ax5013::says

namespace axisc::validator::checks::ax5013 {
namespace {

void guard_in_all_axes(ProgramContext const& context, Report& report) {
  auto const axes =
      axes_where(context, [](EffectiveValues const& values) { return GuardView(values).is_active(); });
  if (axes.empty()) return;
  LoadedMachine const& machine = context.whole.machine;
  auto const reached =
      std::count_if(context.group->axes.begin(), context.group->axes.end(),
                    [&](std::size_t axis) { return machine.axes[axis].type != machine::AxisType::spindle; });
  auto const spans = commands_where(context, is_guard_on);
  if (spans.empty() || static_cast<std::size_t>(reached) == axes.size()) return;
  Finding& finding =
      report_at_last(context, report, spans, message(says::in_all, {{"axes", names_of(axes)}}));
  relate_values(finding, axes, "vib_guard.active", says::active_here);
  finding.help.push_back(message(says::help));
  set_reaction(finding, says::reaction);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .control = "51045",
    .parameters = "vib_guard.active",
    .check = guard_in_all_axes,
};

}  // namespace axisc::validator::checks::ax5013
