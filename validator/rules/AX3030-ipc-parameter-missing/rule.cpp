// AX3030: a stage works only with all its parameters.
#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/views/position_control_view.hpp"

#include <string_view>

namespace axisc::validator::checks::ax3030::says {

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
constexpr Sentence second_bandpass{
    "`filter[0]` without a prototype is CRIT_DAMPING, a band-pass behind it must name its own",
    "`filter[0]` ist ohne Prototyp CRIT_DAMPING, ein Bandpass dahinter muss seinen nennen"};
constexpr Sentence reaction{"it reports each of them as out of range",
                            "sie meldet jeden davon als außerhalb des Bereichs"};
constexpr Sentence help{"set what is missing, or the mode to `NOT_ACTIVE`",
                        "setzen, was fehlt, oder den Modus auf `NOT_ACTIVE`"};

}  // namespace axisc::validator::checks::ax3030::says

namespace axisc::validator::checks::ax3030 {
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
  /// The default does not count here.
  void look_at_prototype(EffectiveValue const& value) {
    if (value.set() || value.unusable) return;
    append(names_, ", ", '`' + name_in_stage(value) + '`');
    lacks_prototype_ = true;
  }

  [[nodiscard]] bool empty() const { return names_.empty(); }
  [[nodiscard]] std::string const& names() const { return names_; }
  [[nodiscard]] std::string const& messages() const { return messages_; }
  [[nodiscard]] bool lacks_prototype() const { return lacks_prototype_; }

 private:
  static void append(std::string& list, std::string_view separator, std::string_view item) {
    if (list.find(item) != std::string::npos) return;
    if (!list.empty()) list.append(separator);
    list.append(item);
  }

  std::string names_;
  std::string messages_;
  bool lacks_prototype_ = false;
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
    bool const is_behind = is_newer && filter.type != stage.newer.front().type;
    if (is_behind) missing.look_at_prototype(*filter.prototype);
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
    if (missing.lacks_prototype()) finding.notes.push_back({says::second_bandpass, {}});
    finding.help.push_back({says::help, {}});
    react(finding, missing.messages(), {says::reaction, {}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<no_frequency, no_order, no_quality, no_damping>,
    .parameters = "ipc.stage[].* ipc.enable",
    .check = ipc_parameter_missing,
};

}  // namespace axisc::validator::checks::ax3030
