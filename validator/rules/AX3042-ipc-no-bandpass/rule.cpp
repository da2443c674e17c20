#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"
#include "validator/views/position_control_view.hpp"

namespace axisc::validator::checks::ax3042::says {

constexpr Sentence headline{"stage {stage} has no band-pass", "Stufe {stage} hat keinen Bandpass"};
constexpr Sentence limit{"{p_axis}: an active stage needs at least one filter of type BANDPASS",
                         "{p_axis}: eine aktive Stufe braucht mindestens einen Filter vom Typ BANDPASS"};
constexpr Sentence help{"`{parameter} BANDPASS` adds one", "`{parameter} BANDPASS` ergänzt einen"};

}  // namespace axisc::validator::checks::ax3042::says

namespace axisc::validator::checks::ax3042 {
namespace {

void ipc_no_bandpass(AxisContext const& axis, Report& report) {
  for (StageView const& stage : axis.position_control.active_stages()) {
    SetValues types;
    bool unknown = false;
    for (StageFilterView const& filter : stage.newer) {
      unknown = unknown || filter.type->unusable;
      if (filter.type->set() && filter.type->value_place()) types.push_back(filter.type);
    }
    if (unknown || types.empty() || stage.bandpass()) continue;
    Finding& finding = report.add(*last_of(types), {says::headline, {{"stage", number(stage.index)}}});
    finding.notes.push_back({says::limit, {{"p_axis", parameter_number(*types.front())}}});
    finding.help.push_back({says::help, {{"parameter", parameter_name(*types.front())}}});
    for (EffectiveValue const* const type : types) {
      if (type != last_of(types)) relate_set_type(finding, *type);
    }
  }
}

}  // namespace

extern constinit Rule const rule{
    .parameters = "ipc.stage[].filter[].type ipc.stage[].mode ipc.enable",
    .check = ipc_no_bandpass,
};

}  // namespace axisc::validator::checks::ax3042
