// AX4005 and AX4006: filters that one axis cannot have together.
#include "validator/fir_view.hpp"
#include "validator/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/kernel_checks.hpp"

namespace axisc::validator::checks {
namespace {

bool guards(EffectiveValue const& active) {
  return !active.unusable && active.value.flag();
}

}  // namespace

void fir_with_hsc(AxisContext const& axis, Report& report) {
  std::vector<FilterView> const hsc = configured_hsc(axis.filters);
  FirView const& fir = axis.fir;
  EffectiveValue const& guard = axis.values.at("vib_guard.active");
  if (hsc.empty() || (!fir.configured() && !guards(guard))) return;
  bool const is_fir = fir.configured();
  Finding& finding = report.add(is_fir ? fir.type : guard, {is_fir ? Text::ax4005 : Text::ax4005_guard, {}});
  for (FilterView const& filter : hsc) {
    if (!filter.prototype.value_place()) continue;
    finding.related.push_back(
        {*filter.prototype.value_place(), {Text::ax4002_filter_here, {{"filter", filter_name(filter)}}}});
  }
  react(finding, "110628", {Text::ax4005_reaction, {}});
  finding.help.push_back({Text::ax4005_help, {}});
}

void fir_with_vibration_guard(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  EffectiveValue const& guard = axis.values.at("vib_guard.active");
  if (!fir.configured() || !guards(guard)) return;
  Finding& finding = report.add(fir.type, {Text::ax4006, {}});
  if (guard.value_place()) {
    finding.related.push_back({*guard.value_place(), {Text::ax4006_guard_here, {}}});
  }
  react(finding, "110630", {Text::ax4006_reaction, {}});
}

}  // namespace axisc::validator::checks
