#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

namespace axisc::validator::checks {
namespace {

void guard_with_fir_in_list(ProgramContext const& context, Report& report) {
  auto const axes =
      axes_where(context, [](EffectiveValues const& values) { return FirView(values).configured(); });
  std::vector<Span> const spans = commands_where(context, [](grammar::NcCommand const& command) {
    return command.kind == grammar::CommandKind::vibration_guard;
  });
  if (axes.empty() || spans.empty()) return;
  Finding& finding =
      report_at_last(context, report, spans, message(Text::ax5005, {{"axes", names_of(axes)}}));
  set_axis(finding, axes);
  relate_values(finding, axes, "filter_fir.type", Text::fir_type_here);
  finding.help.push_back(message(Text::ax5005_help));
  set_reaction(finding, Text::ax5005_reaction);
}

}  // namespace

extern constinit Rule const ax5005{
    .code = Code{5005},
    .name = "guard-with-fir-in-list",
    .control = "50988",
    .silenced_by = codes<5003>,
    .check = guard_with_fir_in_list,
};

}  // namespace axisc::validator::checks
