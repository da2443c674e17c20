#include "validator/engine/rule.hpp"

#include "validator/views/position_control_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

constexpr double largest_weight = 7;

void ipc_weight_limited(AxisContext const& axis, Report& report) {
  for (StageView const& stage : axis.position_control.active_stages()) {
    EffectiveValue const& numerator = stage.weight_numerator;
    EffectiveValue const& denominator = stage.weight_denominator;
    if (numerator.unusable || denominator.unusable || !(denominator.value.number > 0)) continue;
    double const weight = numerator.value.number / denominator.value.number;
    if (weight <= largest_weight) continue;
    Finding& finding = report.add(numerator, {Text::ax3032, {{"weight", number(weight)}}});
    finding.label = Message{Text::ax3032_label,
                            {{"numerator", number(numerator.value.number)},
                             {"denominator", number(denominator.value.number)},
                             {"weight", number(weight)}}};
    finding.notes.push_back({Text::ax3032_limit,
                             {{"numerator", parameter_number(numerator)},
                              {"denominator", parameter_number(denominator)},
                              {"limit", number(largest_weight)}}});
    if (denominator.value_place()) {
      finding.related.push_back({*denominator.value_place(), {Text::ax3032_denominator_here, {}}});
    }
    react(finding, {Text::ax3032_reaction, {}}, number(largest_weight));
  }
}

}  // namespace

extern constinit Rule const ax3032{
    .code = Code{3032},
    .name = "ipc-weight-limited",
    .severity = Severity::warning,
    .control = "70605",
    .check = ipc_weight_limited,
};

}  // namespace axisc::validator::checks
