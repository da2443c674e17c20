#include "validator/engine/rule.hpp"

#include "design/units.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/group_delays.hpp"
#include "validator/views/delay_budget.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax4024::says {

constexpr Sentence headline{
    "the axes of the channel are out of step by {cycles} ({milliseconds}): feedforward differs",
    "die Achsen des Kanals laufen um {cycles} ({milliseconds}) auseinander: die Vorsteuerung ist "
    "verschieden"};
constexpr Sentence deviation{
    "on a line at 45° or a circle at {feed} mm/min that is up to {deviation} µm",
    "auf einer Geraden unter 45° oder einem Kreis mit {feed} mm/min sind das bis zu {deviation} µm"};
constexpr Sentence reading{"that the 5 cycles count for each axis is a reading, not documented",
                           "dass die 5 Zyklen je Achse gelten, ist eine Lesart, nicht dokumentiert"};
constexpr Sentence help{"use the same feedforward in all axes of the channel",
                        "in allen Achsen des Kanals dieselbe Vorsteuerung verwenden"};

}  // namespace axisc::validator::checks::ax4024::says

namespace axisc::validator::checks::ax4024 {
namespace {

void feedforward_delay_differs(GroupContext const& context, Report& report) {
  // Without a line about feedforward nothing differs, and no filter need be designed.
  bool const is_mentioned =
      std::any_of(context.group.axes.begin(), context.group.axes.end(), [&](std::size_t index) {
        return line_about_feedforward(context.whole.machine.axes[index]) != nullptr;
      });
  if (!is_mentioned) return;
  design::CycleTime const cycle_time = context.whole.cycle_time;
  // Where filters differ, AX4011 reports the channel.
  Delays const delays = delays_of(context);
  if (delays.size() < 2 || spread(delays) >= noticeable_delay) return;
  auto const [least, most] = extremes_after_filters(delays);
  double const difference = most->after_filters - least->after_filters;
  if (difference < noticeable_delay) return;
  DelayedAxis const& reported = line_about_feedforward(most->axis) != nullptr ? *most : *least;
  EffectiveValue const* const line = line_about_feedforward(reported.axis);
  if (line == nullptr) return;
  report.axis = reported.axis.name;
  Finding& finding =
      report.add(*line, {says::headline,
                         {{"cycles", counted_cycles(difference)},
                          {"milliseconds", milliseconds(difference * cycle_time.microseconds())}}});
  for (DelayedAxis const& axis : delays) finding.notes.push_back(delay_after_filters_of(axis));
  if (auto const feed = lowest_velocity_limit(context.whole.machine, context.group)) {
    finding.notes.push_back({says::deviation,
                             {{"feed", number(*feed * design::mm_per_min_of_um_per_s)},
                              {"deviation", number(deviation_of_mismatch(*feed, difference, cycle_time))}}});
  }
  finding.notes.push_back({says::reading, {}});
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "vorsteuer.vorsteuerung vorsteuer.default_active vorsteuer.global_disable "
        "vorsteuer.feedforward_without_delay vorsteuer.timeconst_sym_filter kenngr.antr_typ "
        "getriebe[].dynamik.vb_max",
    .needs = Needs::cycle_time,
    .check = feedforward_delay_differs,
};

}  // namespace axisc::validator::checks::ax4024
