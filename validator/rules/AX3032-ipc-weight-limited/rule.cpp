#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/position_control_view.hpp"

#include <cmath>

namespace axisc::validator::checks::ax3032::says {

constexpr Sentence headline{"the weight {weight} is limited to 7",
                            "das Gewicht {weight} wird auf 7 begrenzt"};
constexpr Sentence label{"{numerator} / {denominator} = {weight}", "{numerator} / {denominator} = {weight}"};
constexpr Sentence limit{"{numerator} / {denominator} ≤ {limit}", "{numerator} / {denominator} ≤ {limit}"};
constexpr Sentence denominator_here{"the denominator is set here", "hier wird der Nenner gesetzt"};
constexpr Sentence reaction{"it limits the weight", "sie begrenzt das Gewicht"};
constexpr Sentence help{"`{parameter} {largest}` is the largest here",
                        "`{parameter} {largest}` ist hier der größte Wert"};

}  // namespace axisc::validator::checks::ax3032::says

namespace axisc::validator::checks::ax3032 {
namespace {

constexpr double largest_weight = 7;

void ipc_weight_limited(AxisContext const& axis, Report& report) {
  for (StageView const& stage : axis.position_control.active_stages()) {
    EffectiveValue const& numerator = stage.weight_numerator;
    EffectiveValue const& denominator = stage.weight_denominator;
    if (numerator.unusable || denominator.unusable || !(denominator.value.number > 0)) continue;
    double const weight = numerator.value.number / denominator.value.number;
    if (weight <= largest_weight) continue;
    Finding& finding = report.add(numerator, {says::headline, {{"weight", number(weight)}}});
    finding.label = Message{says::label,
                            {{"numerator", number(numerator.value.number)},
                             {"denominator", number(denominator.value.number)},
                             {"weight", number(weight)}}};
    finding.notes.push_back({says::limit,
                             {{"numerator", parameter_number(numerator)},
                              {"denominator", parameter_number(denominator)},
                              {"limit", number(largest_weight)}}});
    if (denominator.value_place()) {
      finding.related.push_back({*denominator.value_place(), {says::denominator_here, {}}});
    }
    double const largest = std::floor(largest_weight * denominator.value.number);
    finding.help.push_back(
        {says::help, {{"parameter", parameter_name(numerator)}, {"largest", number(largest)}}});
    react(finding, {says::reaction, {}}, number(largest_weight).written());
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .control = "70605",
    .parameters = "ipc.stage[].weight_fact_num ipc.stage[].weight_fact_denom ipc.stage[].mode ipc.enable",
    .check = ipc_weight_limited,
};

}  // namespace axisc::validator::checks::ax3032
