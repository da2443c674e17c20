#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/position_control_view.hpp"

#include <algorithm>
#include <array>

namespace axisc::validator::checks::ax4016::says {

constexpr Sentence headline{
    "the additive velocity is sent to the drive, but its scaling has its default values",
    "die additive Geschwindigkeit geht an den Antrieb, aber ihre Skalierung hat die Standardwerte"};
constexpr Sentence defaults{
    "P-AXIS-00205 to 00207: by default {denominator} µm per minute (0.001° per minute) are {numerator} "
    "increment",
    "P-AXIS-00205 bis 00207: mit den Standardwerten sind {denominator} µm je Minute (0,001° je Minute) "
    "{numerator} Inkrement"};
constexpr Sentence mapping{"the process data must contain the additive velocity",
                           "die Prozessdaten müssen die additive Geschwindigkeit enthalten"};
constexpr Sentence mapping_sercos{
    "the process data must contain the additive velocity, for SERCOS S-0-0037",
    "die Prozessdaten müssen die additive Geschwindigkeit enthalten, bei SERCOS S-0-0037"};
constexpr Sentence reaction{"it reports that the cyclic telegram has no additive velocity",
                            "sie meldet, dass das zyklische Telegramm keine additive Geschwindigkeit hat"};
constexpr Sentence help{
    "set `antr.v_reso_num`, `antr.v_reso_denom` and `antr.v_time_base` as the drive is configured",
    "`antr.v_reso_num`, `antr.v_reso_denom` und `antr.v_time_base` so setzen, wie der Antrieb konfiguriert "
    "ist"};

}  // namespace axisc::validator::checks::ax4016::says

namespace axisc::validator::checks::ax4016 {
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
  Finding& finding = report.add(last != nullptr ? *last : view.enable, {says::headline, {}});
  finding.notes.push_back(
      {says::defaults,
       {{"denominator", number(scaling[1]->value.number)}, {"numerator", number(scaling[0]->value.number)}}});
  machine::DriveType const* const drive = drive_of(loaded(axis));
  bool const sercos = drive != nullptr && drive->word == "SERCOS";
  finding.notes.push_back({sercos ? says::mapping_sercos : says::mapping, {}});
  finding.help.push_back({says::help, {}});
  react(finding, {says::reaction, {}});
  if (last != nullptr) relate_enable(finding, view);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .control = "70607",
    .parameters =
        "antr.v_reso_num antr.v_reso_denom antr.v_time_base ipc.enable antr.operation_mode kenngr.antr_typ",
    .check = ipc_scaling_missing,
};

}  // namespace axisc::validator::checks::ax4016
