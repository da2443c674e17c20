#include "validator/rules/position_control_words.hpp"

#include "validator/rules/filter_words.hpp"

#include <algorithm>

namespace axisc::validator::says {

constexpr Sentence ipc_mode_here{"the mode is `{mode}`", "der Modus ist `{mode}`"};
constexpr Sentence ipc_enabled_here{"Improved Position Control is enabled here",
                                    "hier wird die optimierte Lageregelung eingeschaltet"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {

void relate_enable(Finding& finding, PositionControlView const& view) {
  if (view.enable.value_place()) {
    finding.related.push_back({*view.enable.value_place(), {says::ipc_enabled_here, {}}});
  }
}

void relate_mode(Finding& finding, StageView const& stage) {
  if (stage.mode.value_place()) {
    finding.related.push_back(
        {*stage.mode.value_place(), {says::ipc_mode_here, {{"mode", symbol_word(stage.mode)}}}});
  }
}

EffectiveValue const* last_of(SetValues const& values) {
  auto const last = std::max_element(values.begin(), values.end(),
                                     [](EffectiveValue const* left, EffectiveValue const* right) {
                                       return *left->value_place() < *right->value_place();
                                     });
  return last == values.end() ? nullptr : *last;
}

}  // namespace axisc::validator::checks
