#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

namespace axisc::validator::checks {
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
      report_at_last(context, report, spans, message(Text::ax5004, {{"axes", names_of(axes)}}));
  set_axis(finding, axes);
  relate_values(finding, axes, active, Text::ax5004_active_here);
  finding.help.push_back(message(Text::ax5004_help));
  set_reaction(finding, Text::ax5004_reaction);
}

}  // namespace

extern constinit Rule const ax5004{
    .code = Code{5004},
    .name = "filter-with-guard-in-list",
    .control = "50987",
    .check = filter_with_guard_in_list,
};

}  // namespace axisc::validator::checks
