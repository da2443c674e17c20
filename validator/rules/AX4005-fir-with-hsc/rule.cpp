#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/hsc_words.hpp"
#include "validator/rules/program_helpers.hpp"
#include "validator/views/fir_view.hpp"
#include "validator/views/hsc_view.hpp"

namespace axisc::validator::checks::ax4005::says {

constexpr Sentence headline{"an axis cannot have both a FIR filter and an HSC filter",
                            "eine Achse kann nicht zugleich einen FIR-Filter und einen HSC-Filter haben"};
constexpr Sentence guard{"an axis cannot have both the Vibration Guard and an HSC filter",
                         "eine Achse kann nicht zugleich den Vibration Guard und einen HSC-Filter haben"};
constexpr Sentence command{
    "`#VIB GUARD` reaches axes with an HSC filter, which cannot have both: {axes}",
    "`#VIB GUARD` erreicht Achsen mit HSC-Filter, die nicht beides haben können: {axes}"};
constexpr Sentence reaction{"it reports that the combination is not permitted",
                            "sie meldet, dass beides zusammen nicht zulässig ist"};
constexpr Sentence help{"FIR filters replace HSC filters from build V3.1.3075.02",
                        "FIR-Filter ersetzen HSC-Filter ab Stand V3.1.3075.02"};
constexpr Sentence help_command{"remove `#VIB GUARD`, or the HSC filters of these axes",
                                "`#VIB GUARD` oder die HSC-Filter dieser Achsen entfernen"};

}  // namespace axisc::validator::checks::ax4005::says

namespace axisc::validator::checks::ax4005 {
namespace {

bool guards(EffectiveValue const& active) {
  return active.is_on();
}

void fir_with_hsc(AxisContext const& axis, Report& report) {
  std::vector<FilterView> const hsc = configured_hsc(axis.filters);
  FirView const& fir = axis.fir;
  EffectiveValue const& guard = axis.values.at("vib_guard.active");
  if (hsc.empty() || (!fir.configured() && !guards(guard))) return;
  bool const is_fir = fir.configured();
  Finding& finding = report.add(is_fir ? fir.type : guard, {is_fir ? says::headline : says::guard, {}});
  for (FilterView const& filter : hsc) relate_hsc_filter(finding, filter);
  react(finding, {says::reaction, {}});
  finding.help.push_back({says::help, {}});
}

void guard_with_hsc(ProgramContext const& context, Report& report) {
  auto const axes =
      axes_where(context, [](EffectiveValues const& values) { return !configured_hsc(values).empty(); });
  auto const spans = commands_where(context, is_guard_on);
  if (axes.empty() || spans.empty()) return;
  Finding& finding =
      report_at_last(context, report, spans, message(says::command, {{"axes", names_of(axes)}}));
  set_axis(finding, axes);
  finding.help.push_back(message(says::help_command));
  set_reaction(finding, says::reaction);
}

}  // namespace

extern constinit Rule const rule{
    .control = "110628",
    .parameters = "filter_fir.type vib_guard.active filter[].prototype filter[].type",
    .check = fir_with_hsc,
    .program_check = guard_with_hsc,
};

}  // namespace axisc::validator::checks::ax4005
