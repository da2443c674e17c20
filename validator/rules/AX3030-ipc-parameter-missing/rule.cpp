// AX3030: a stage works only with all its parameters.
#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/views/position_control_view.hpp"

#include <string_view>

namespace axisc::validator::says {

constexpr Sentence headline{
    "stage {stage} works in mode `{mode}`, but not all its parameters are given",
    "Stufe {stage} arbeitet im Modus `{mode}`, aber nicht alle ihre Parameter sind angegeben"};
constexpr Sentence label{"missing: {parameters}", "es fehlt: {parameters}"};
constexpr Sentence limit{
    "an active stage needs order (1 to 3), fg_f0 and q_factor: their defaults are invalid",
    "eine aktive Stufe braucht order (1 bis 3), fg_f0 und q_factor: deren Standardwerte sind ungültig"};
constexpr Sentence limit_simulated{
    "an active stage needs order (1 to 3), fg_f0, q_factor, in INDIRECT and SET_POINT also damping: their "
    "defaults are invalid",
    "eine aktive Stufe braucht order (1 bis 3), fg_f0, q_factor, in INDIRECT und SET_POINT auch damping: "
    "deren Standardwerte sind ungültig"};
constexpr Sentence reaction{"it reports each of them as out of range",
                            "sie meldet jeden davon als außerhalb des Bereichs"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

// Message numbers of the control.
constexpr std::string_view no_frequency = "70592";
constexpr std::string_view no_order = "70593";
constexpr std::string_view no_quality = "70594";
constexpr std::string_view no_damping = "70599";

/// `filter.order`, without the stage, which the headline names.
std::string name_in_stage(EffectiveValue const& value) {
  std::string const name = parameter_name(value);
  constexpr std::string_view behind_stage = "].";
  return name.substr(name.find(behind_stage) + behind_stage.size());
}

/// Names of the missing parameters, and the control's numbers for them.
class Missing {
 public:
  /// Unusable values have findings of their own.
  void look_at(EffectiveValue const& value, EffectiveValue const* other_spelling, std::string_view message) {
    bool const given =
        configured(value) || value.unusable || (other_spelling != nullptr && configured(*other_spelling));
    if (given) return;
    append(names_, ", ", '`' + name_in_stage(value) + '`');
    append(messages_, "/", message);
  }

  [[nodiscard]] bool empty() const { return names_.empty(); }
  [[nodiscard]] std::string const& names() const { return names_; }
  [[nodiscard]] std::string const& messages() const { return messages_; }

 private:
  static void append(std::string& list, std::string_view separator, std::string_view item) {
    if (list.find(item) != std::string::npos) return;
    if (!list.empty()) list.append(separator);
    list.append(item);
  }

  std::string names_;
  std::string messages_;
};

Missing missing_in(StageView const& stage) {
  Missing missing;
  for (StageFilterView const& filter : stage.filters()) {
    // If the spellings are mixed, AX3039 reports it; a value given in the other spelling is not also missing.
    bool const is_newer = filter.type != nullptr;
    StageFilterView const* const other = is_newer ? &stage.older : nullptr;
    missing.look_at(filter.order, other != nullptr ? &other->order : nullptr, no_order);
    missing.look_at(filter.frequency, other != nullptr ? &other->frequency : nullptr, no_frequency);
    if (filter.kind != StageFilterType::bandpass) continue;
    missing.look_at(filter.quality, other != nullptr ? &other->quality : nullptr, no_quality);
  }
  if (stage.simulates()) missing.look_at(stage.damping(), nullptr, no_damping);
  return missing;
}

void ipc_parameter_missing(AxisContext const& axis, Report& report) {
  for (StageView const& stage : axis.position_control.active_stages()) {
    Missing const missing = missing_in(stage);
    if (missing.empty()) continue;
    Finding& finding = report.add(
        stage.mode, {says::headline, {{"stage", number(stage.index)}, {"mode", symbol_word(stage.mode)}}});
    finding.label = Message{says::label, {{"parameters", missing.names()}}};
    finding.notes.push_back({stage.simulates() ? says::limit_simulated : says::limit, {}});
    react(finding, missing.messages(), {says::reaction, {}});
  }
}

}  // namespace

extern constinit Rule const ax3030{
    .code = Code{3030},
    .name = "ipc-parameter-missing",
    .control = control_numbers<no_frequency, no_order, no_quality, no_damping>,
    .parameters = "ipc.stage[].* ipc.enable",
    .check = ipc_parameter_missing,
};

}  // namespace axisc::validator::checks
