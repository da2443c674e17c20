#include "validator/engine/rule.hpp"

#include "validator/views/drive.hpp"
#include "validator/views/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"

#include <algorithm>
#include <array>

namespace axisc::validator::checks {
namespace {

void ipc_scaling_missing(AxisContext const& axis, Report& report) {
  PositionControlView const& view = axis.position_control;
  if (!view.enabled() || position_controller(loaded(axis)) != machine::PositionController::drive) return;
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
  machine::DriveType const* const drive = drive_of(loaded(axis));
  bool const sercos = drive != nullptr && drive->word == "SERCOS";
  finding.notes.push_back({sercos ? Text::ax4016_mapping_sercos : Text::ax4016_mapping, {}});
  react(finding, {Text::ax4016_reaction, {}});
  if (last != nullptr) relate_enable(finding, view);
}

}  // namespace

extern constinit Rule const ax4016{
    .code = Code{4016},
    .name = "ipc-scaling-missing",
    .severity = Severity::warning,
    .control = "70607",
    .check = ipc_scaling_missing,
};

}  // namespace axisc::validator::checks
