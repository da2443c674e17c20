#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"
#include "validator/views/fir_view.hpp"

namespace axisc::validator::checks::ax5006::says {

constexpr Sentence headline{"#FILTER ON has no effect on axes without a FIR type: {axes}",
                            "#FILTER ON wirkt nicht auf Achsen ohne FIR-Typ: {axes}"};
constexpr Sentence asynchronous{"filtered and unfiltered axes of one channel run asynchronously",
                                "gefilterte und ungefilterte Achsen eines Kanals laufen asynchron"};
constexpr Sentence reaction{"the filter of these axes stays inactive",
                            "der Filter dieser Achsen bleibt inaktiv"};
constexpr Sentence help{
    "set `filter_fir.type` in their lists: 1 moving average, 2 Gaussian, 3 windowed sinc, 4 time delay",
    "`filter_fir.type` in ihren Listen setzen: 1 gleitender Mittelwert, 2 Gauß, 3 Windowed Sinc, 4 "
    "Zeitverzögerung"};

}  // namespace axisc::validator::checks::ax5006::says

namespace axisc::validator::checks::ax5006 {
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
      report_at_last(context, report, spans, message(says::headline, {{"axes", names_of(axes)}}));
  set_axis(finding, axes);
  finding.notes.push_back(message(says::asynchronous));
  finding.help.push_back(message(says::help));
  set_reaction(finding, says::reaction);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .control = "51043/51044",
    .parameters = "filter_fir.type",
    .check = filter_without_type,
};

}  // namespace axisc::validator::checks::ax5006
