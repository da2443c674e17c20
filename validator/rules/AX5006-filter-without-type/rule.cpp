#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

namespace axisc::validator::checks {
namespace {

void filter_without_type(ProgramContext const& context, Report& report) {
  auto const axes = axes_where(context, [](EffectiveValues const& values) {
    FirView const fir(values);
    return !fir.configured() && !fir.type.unusable;
  });
  std::vector<Span> const spans = commands_where(
      context, [&](grammar::NcCommand const& command) { return is_fir_filter_on(context, command); });
  if (axes.empty() || spans.empty()) return;
  Finding& finding =
      report_at_last(context, report, spans, message(Text::ax5006, {{"axes", names_of(axes)}}));
  set_axis(finding, axes);
  finding.notes.push_back(message(Text::ax5006_asynchronous));
  finding.help.push_back(message(Text::ax5006_help));
  set_reaction(finding, Text::ax5006_reaction);
}

}  // namespace

extern constinit Rule const ax5006{
    .code = Code{5006},
    .name = "filter-without-type",
    .severity = Severity::warning,
    .control = "51043/51044",
    .check = filter_without_type,
};

}  // namespace axisc::validator::checks
