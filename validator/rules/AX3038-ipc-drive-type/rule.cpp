#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/position_control_view.hpp"

namespace axisc::validator::checks::ax3038::says {

constexpr Sentence headline{"Improved Position Control is not available for the drive type \"{drive}\"",
                            "die optimierte Lageregelung gibt es für den Antriebstyp „{drive}“ nicht"};
constexpr Sentence limit{"{p_axis}: available for SERCOS (2), PROFIDRIVE (3) and CANopen (8)",
                         "{p_axis}: verfügbar für SERCOS (2), PROFIDRIVE (3) und CANopen (8)"};
constexpr Sentence help{"correct the drive type, or set `{enable}` to 0",
                        "den Antriebstyp berichtigen, oder `{enable}` auf 0 setzen"};

}  // namespace axisc::validator::checks::ax3038::says

namespace axisc::validator::checks::ax3038 {
namespace {

void ipc_drive_type(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  EffectiveValue const& type = axis.values.at("kenngr.antr_typ");
  auto const& named = loaded(axis).drive;
  bool const stated = named || (type.set() && !type.unusable);
  machine::DriveType const* const drive = drive_of(loaded(axis));
  if (!view.enabled() || !stated || (drive != nullptr && drive->digital)) return;
  Message message{says::headline,
                  {{"drive", drive != nullptr ? drive_name(*drive) : number(type.value.number)}}};
  Finding& finding = named ? report.add(named->place, *type.row, type.slot, std::move(message))
                           : report.add(type, std::move(message));
  finding.notes.push_back({says::limit, {{"p_axis", parameter_number(type)}}});
  relate_enable(finding, view);
  finding.help.push_back({says::help, {{"enable", parameter_name(view.enable)}}});
}

}  // namespace

extern constinit Rule const rule{
    .parameters = "kenngr.antr_typ ipc.enable",
    .check = ipc_drive_type,
};

}  // namespace axisc::validator::checks::ax3038
