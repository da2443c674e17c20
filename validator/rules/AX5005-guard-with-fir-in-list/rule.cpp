#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/fir_view.hpp"

namespace axisc::validator::checks::ax5005::says {

constexpr Sentence headline{
    "#VIB GUARD must not be used while an axis list sets a FIR type: {axes}",
    "#VIB GUARD darf nicht verwendet werden, wenn eine Achsliste einen FIR-Typ setzt: {axes}"};
constexpr Sentence reaction{"the FIR filter is not active", "der FIR-Filter ist nicht aktiv"};
constexpr Sentence help{
    "set `filter_fir.type 0`, or activate the Vibration Guard in the lists of axes without a FIR filter",
    "`filter_fir.type 0` setzen, oder den Vibration Guard in den Listen der Achsen ohne FIR-Filter "
    "aktivieren"};

}  // namespace axisc::validator::checks::ax5005::says

namespace axisc::validator::checks::ax5005 {
namespace {

void guard_with_fir_in_list(ProgramContext const& context, Report& report) {
  auto const axes =
      axes_where(context, [](EffectiveValues const& values) { return FirView(values).configured(); });
  std::vector<Span> const spans = commands_where(context, [](grammar::NcCommand const& command) {
    return command.kind == grammar::CommandKind::vibration_guard;
  });
  if (axes.empty() || spans.empty()) return;
  Finding& finding =
      report_at_last(context, report, spans, message(says::headline, {{"axes", names_of(axes)}}));
  set_axis(finding, axes);
  relate_values(finding, axes, "filter_fir.type", validator::says::fir_type_here);
  finding.help.push_back(message(says::help));
  set_reaction(finding, says::reaction);
}

}  // namespace

extern constinit Rule const rule{
    .control = "50988",
    .parameters = "filter_fir.type",
    .silenced_by = codes<5003>,
    .program_check = guard_with_fir_in_list,
};

}  // namespace axisc::validator::checks::ax5005
