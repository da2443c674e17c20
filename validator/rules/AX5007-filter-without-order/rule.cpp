#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/sentences.hpp"
#include "validator/views/fir_view.hpp"

namespace axisc::validator::checks::ax5007::says {

constexpr Sentence headline{"#FILTER ON has no effect on axes without an order: {axes}",
                            "#FILTER ON wirkt nicht auf Achsen ohne Ordnung: {axes}"};
constexpr Sentence help{
    "give an order: `#FILTER ON [ORDER=..]`, or `filter_fir.order` in the lists",
    "eine Ordnung angeben: `#FILTER ON [ORDER=..]`, oder `filter_fir.order` in den Listen"};

}  // namespace axisc::validator::checks::ax5007::says

namespace axisc::validator::checks::ax5007 {
namespace {

bool has_type_but_no_order(EffectiveValues const& values) {
  FirView const fir(values);
  bool const unknown = fir.order.unusable || fir.order_time.unusable;
  return fir.configured() && !unknown && !(fir.order.value.number > 0) && !(fir.order_time.value.number > 0);
}

void filter_without_order(ProgramContext const& context, Report& report) {
  if (context.program.gives_order) return;
  auto const axes = axes_where(context, has_type_but_no_order);
  std::vector<Span> const spans = commands_where(
      context, [&](grammar::NcCommand const& command) { return is_fir_filter_on(context, command); });
  if (axes.empty() || spans.empty()) return;
  Finding& finding =
      report_at_last(context, report, spans, message(says::headline, {{"axes", names_of(axes)}}));
  set_axis(finding, axes);
  relate_values(finding, axes, "filter_fir.type", validator::says::fir_type_here);
  finding.help.push_back(message(says::help));
  set_reaction(finding, validator::says::filter_reaction_inactive);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "filter_fir.order filter_fir.order_time filter_fir.type",
    .check = filter_without_order,
};

}  // namespace axisc::validator::checks::ax5007
