#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/feedforward_view.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax3050::says {

constexpr Sentence headline{"a time delay of the position alone has no effect here",
                            "eine Zeitverzögerung der Position allein hat hier keine Wirkung"};
constexpr Sentence no_delay{"no filter of the axis is an active TIME_DELAY",
                            "kein Filter der Achse ist ein aktives TIME_DELAY"};
constexpr Sentence no_feedforward{"nothing is fed forward: P-AXIS-00223 is NONE",
                                  "es wird nichts vorgesteuert: P-AXIS-00223 ist NONE"};
constexpr Sentence help_delay{"remove the line, or make a filter an active `TIME_DELAY`",
                              "die Zeile entfernen, oder einen Filter zu einem aktiven `TIME_DELAY` machen"};
constexpr Sentence help_feedforward{
    "remove the line, or name in P-AXIS-00223 what is fed forward",
    "die Zeile entfernen, oder in P-AXIS-00223 nennen, was vorgesteuert wird"};

}  // namespace axisc::validator::checks::ax3050::says

namespace axisc::validator::checks::ax3050 {
namespace {

bool may_be_active_delay(FilterView const& filter) {
  if (filter.port != FilterPort::setpoint) return false;
  return filter.type_unusable() ||
         (filter.active() && filter.standard_type == design::FilterType::time_delay);
}

void delay_only_position_without_delay(AxisContext const& axis, Report& report) {
  EffectiveValue const& position_alone = axis.values.at("kenngr.delay_filter_only_position");
  if (!position_alone.is_on()) return;
  FeedforwardView const feedforward(axis.values);
  bool const has_delay = std::any_of(axis.filters.begin(), axis.filters.end(), may_be_active_delay);
  if (has_delay && !feedforward.is_none()) return;
  Finding& finding = report.add(position_alone, {says::headline, {}});
  finding.notes.push_back({has_delay ? says::no_feedforward : says::no_delay, {}});
  finding.help.push_back({has_delay ? says::help_feedforward : says::help_delay, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "kenngr.delay_filter_only_position vorsteuer.vorsteuerung filters[].type filters[].enable "
        "filters[].order",
    .check = delay_only_position_without_delay,
};

}  // namespace axisc::validator::checks::ax3050
