// AX3038, AX3043 and AX4016: what Improved Position Control needs of the drive.
#include "validator/drive.hpp"
#include "validator/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_checks.hpp"

#include <algorithm>
#include <array>

namespace axisc::validator::checks {
namespace {

LoadedAxis const& loaded(AxisContext const& axis) {
  return axis.machine.axes[axis.index];
}

void relate_enable(Finding& finding, PositionControlView const& view) {
  if (view.enable.value_place()) {
    finding.related.push_back({*view.enable.value_place(), {Text::ipc_enabled_here, {}}});
  }
}

}  // namespace

void ipc_drive_type(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  EffectiveValue const& type = axis.values.at("kenngr.antr_typ");
  auto const& named = loaded(axis).drive;
  bool const stated = named || (type.set() && !type.unusable);
  DriveType const* const drive = drive_of(loaded(axis));
  if (!view.enabled() || !stated || (drive != nullptr && drive->digital)) return;
  Message message{Text::ax3038,
                  {{"drive", drive != nullptr ? std::string(drive->word) : number(type.value.number)}}};
  Finding& finding = named ? report.add(named->place, *type.row, type.slot, std::move(message))
                           : report.add(type, std::move(message));
  finding.notes.push_back({Text::ax3038_limit, {{"p_axis", parameter_number(type)}}});
  relate_enable(finding, view);
}

void ipc_operation_mode(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  EffectiveValue const& mode = axis.values.at("antr.operation_mode");
  if (!view.enabled() || !mode.set() || !is_open_loop(mode)) return;
  Finding& finding = report.add(mode, {Text::ax3043, {{"mode", std::string(mode.value.text)}}});
  finding.notes.push_back({Text::ax3043_limit, {{"p_axis", parameter_number(mode)}}});
  react(finding, "70602", {Text::ax3043_reaction, {}});
  relate_enable(finding, view);
}

void ipc_scaling_missing(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  if (!view.enabled() || position_controller(loaded(axis)) != PositionController::drive) return;
  std::array const scaling{&axis.values.at("antr.v_reso_num"), &axis.values.at("antr.v_reso_denom"),
                           &axis.values.at("antr.v_time_base")};
  bool const given = std::any_of(scaling.begin(), scaling.end(), [](EffectiveValue const* value) {
    return configured(*value) || value->unusable;
  });
  if (given) return;
  EffectiveValue const* last = nullptr;
  for (EffectiveValue const* const value : scaling) {
    if (value->set() && (last == nullptr || last->value_place() < value->value_place())) last = value;
  }
  Finding& finding = report.add(last != nullptr ? *last : view.enable, {Text::ax4016, {}});
  finding.notes.push_back(
      {Text::ax4016_defaults,
       {{"denominator", number(scaling[1]->value.number)}, {"numerator", number(scaling[0]->value.number)}}});
  DriveType const* const drive = drive_of(loaded(axis));
  bool const sercos = drive != nullptr && drive->word == "SERCOS";
  finding.notes.push_back({sercos ? Text::ax4016_mapping_sercos : Text::ax4016_mapping, {}});
  react(finding, "70607", {Text::ax4016_reaction, {}});
  if (last != nullptr) relate_enable(finding, view);
}

}  // namespace axisc::validator::checks
