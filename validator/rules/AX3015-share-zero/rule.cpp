#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/sentences.hpp"
#include "validator/views/fir_view.hpp"

#include <string>

namespace axisc::validator::checks::ax3015::says {

constexpr Sentence headline{"share 0: `{filter}` has no effect",
                            "Signalanteil 0: `{filter}` hat keine Wirkung"};
constexpr Sentence label{"no part of the signal passes the filter",
                         "kein Teil des Signals läuft durch den Filter"};
constexpr Sentence limit{"{p_axis}: 100 % is the whole signal, 0 % none of it",
                         "{p_axis}: 100 % ist das ganze Signal, 0 % nichts davon"};
constexpr Sentence help{"`{enable} 0` is the clear way to switch the filter off",
                        "`{enable} 0` schaltet den Filter eindeutig aus"};
constexpr Sentence help_whole{"`{share} 100` sends the whole signal through the filter",
                              "`{share} 100` führt das ganze Signal durch den Filter"};

}  // namespace axisc::validator::checks::ax3015::says

namespace axisc::validator::checks::ax3015 {
namespace {

bool works(FilterView const& filter) {
  return filter.active() || (filter.is_hsc() && filter.port == FilterPort::setpoint);
}

void check(EffectiveValue const& share, std::string filter, EffectiveValue const& enable, Report& report) {
  if (share.unusable || share.value.number != 0) return;
  Finding& finding = report.add(share, {says::headline, {{"filter", std::move(filter)}}});
  finding.label = Message{says::label, {}};
  finding.notes.push_back({says::limit, {{"p_axis", parameter_number(share)}}});
  if (enable.value.flag()) {
    finding.help.push_back({says::help, {{"enable", parameter_name(enable)}}});
  } else {
    finding.help.push_back({says::help_whole, {{"share", parameter_name(share)}}});
  }
  react(finding, {validator::says::filter_reaction_inactive, {}});
}

void share_zero(AxisContext const& axis, Report& report) {
  for (FilterView const& filter : axis.filters) {
    if (works(filter)) check(filter.share, filter_name(filter), filter.enable, report);
  }
  FirView const& fir = axis.fir;
  if (fir.configured()) check(fir.share, "filter_fir", fir.enable, report);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "filters[].share_percent filters[].enable filters[].order filters[].type filter_fir.share "
        "filter_fir.enable filter_fir.type",
    .check = share_zero,
};

}  // namespace axisc::validator::checks::ax3015
