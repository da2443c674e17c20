#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/views/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/hsc_words.hpp"

namespace axisc::validator::checks {
namespace {

bool guards(EffectiveValue const& active) {
  return !active.unusable && active.value.flag();
}

void fir_with_hsc(AxisContext const& axis, Report& report) {
  std::vector<FilterView> const hsc = configured_hsc(axis.filters);
  FirView const& fir = axis.fir;
  EffectiveValue const& guard = axis.values.at("vib_guard.active");
  if (hsc.empty() || (!fir.configured() && !guards(guard))) return;
  bool const is_fir = fir.configured();
  Finding& finding = report.add(is_fir ? fir.type : guard, {is_fir ? Text::ax4005 : Text::ax4005_guard, {}});
  for (FilterView const& filter : hsc) relate_hsc_filter(finding, filter);
  react(finding, {Text::ax4005_reaction, {}});
  finding.help.push_back({Text::ax4005_help, {}});
}

}  // namespace

extern constinit Rule const ax4005{
    .code = Code{4005},
    .name = "fir-with-hsc",
    .control = "110628",
    .check = fir_with_hsc,
};

}  // namespace axisc::validator::checks
