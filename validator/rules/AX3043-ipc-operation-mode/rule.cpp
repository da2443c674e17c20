#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/position_control_view.hpp"

namespace axisc::validator::checks::ax3043::says {

constexpr Sentence headline{
    "Improved Position Control needs a closed position loop, not `{mode}`",
    "die optimierte Lageregelung braucht einen geschlossenen Lageregelkreis, nicht `{mode}`"};
constexpr Sentence limit{"{p_axis}: position control in the CNC or in the drive",
                         "{p_axis}: Lageregelung in der CNC oder im Antrieb"};
constexpr Sentence reaction{"it reports that this operation mode does not allow it",
                            "sie meldet, dass diese Betriebsart das nicht zulässt"};
constexpr Sentence help{"choose position control in the CNC or in the drive, or set `{enable}` to 0",
                        "Lageregelung in der CNC oder im Antrieb wählen, oder `{enable}` auf 0 setzen"};

}  // namespace axisc::validator::checks::ax3043::says

namespace axisc::validator::checks::ax3043 {
namespace {

void ipc_operation_mode(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  EffectiveValue const& mode = axis.values.at("antr.operation_mode");
  if (!view.enabled() || !mode.set() || !is_open_loop(mode)) return;
  Finding& finding = report.add(mode, {says::headline, {{"mode", std::string(mode.value.text)}}});
  finding.notes.push_back({says::limit, {{"p_axis", parameter_number(mode)}}});
  finding.help.push_back({says::help, {{"enable", parameter_name(view.enable)}}});
  react(finding, {says::reaction, {}});
  relate_enable(finding, view);
}

}  // namespace

extern constinit Rule const rule{
    .control = "70602",
    .parameters = "antr.operation_mode ipc.enable",
    .check = ipc_operation_mode,
};

}  // namespace axisc::validator::checks::ax3043
