#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/sentences.hpp"
#include "validator/views/interface_filter_time.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::validator::checks::ax3051::says {

constexpr Sentence twice{"the additional interface has two filters: `{time}` and `{filter}`",
                         "die Zusatzschnittstelle hat zwei Filter: `{time}` und `{filter}`"};
constexpr Sentence other_here{"the other filter", "der andere Filter"};
constexpr Sentence which{"which of them acts is not documented; an image is not made of it",
                         "welcher davon wirkt, ist nicht dokumentiert; ein Abbild entsteht daraus nicht"};
constexpr Sentence keep_one{"`{time} 0` keeps the newer filter", "`{time} 0` behält den neueren Filter"};
constexpr Sentence too_short{"the time constant of the additional interface is shorter than an NC cycle",
                             "die Zeitkonstante der Zusatzschnittstelle ist kürzer als ein NC-Zyklus"};
constexpr Sentence limit_unknown{
    "PT2 filters of lists need at least one cycle; what the control makes of this one is not documented",
    "PT2-Filter in Listen brauchen mindestens einen Zyklus; was die Steuerung aus diesem macht, ist nicht "
    "dokumentiert"};
constexpr Sentence switch_off{"`{time} {shortest}` is the shortest, `{time} 0` switches the filter off",
                              "`{time} {shortest}` ist die kürzeste, `{time} 0` schaltet den Filter aus"};

}  // namespace axisc::validator::checks::ax3051::says

namespace axisc::validator::checks::ax3051 {
namespace {

void interface_filter_time_fits(AxisContext const& axis, Report& report) {
  EffectiveValue const& time = axis.values.at(interface_filter_time_name);
  if (time.unusable || !(time.value.number > 0) || !axis.values.at("lr_param.add_interface.enable").is_on()) {
    return;
  }
  auto const other = std::find_if(axis.filters.begin(), axis.filters.end(), [](FilterView const& filter) {
    return filter.port == FilterPort::additional_interface && filter.active();
  });
  if (other != axis.filters.end()) {
    Finding& finding =
        report.add(time, {says::twice, {{"time", parameter_name(time)}, {"filter", filter_name(*other)}}});
    if (auto const place = other->anchor(other->enable).value_place()) {
      finding.related.push_back({*place, {says::other_here, {}}});
    }
    finding.notes.push_back({says::which, {}});
    finding.help.push_back({says::keep_one, {{"time", parameter_name(time)}}});
  }
  if (axis.cycle_time.cycles({time.value.number}) >= 1) return;
  Finding& finding = report.add(time, {says::too_short, {}});
  finding.label = time_in_cycles(time.value.number, axis.cycle_time);
  finding.notes.push_back({says::limit_unknown, {}});
  finding.help.push_back(
      {says::switch_off,
       {{"time", parameter_name(time)}, {"shortest", number(std::ceil(axis.cycle_time.microseconds()))}}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "kenngr.in_add_interface_filter_time lr_param.add_interface.enable "
        "lr_param.add_interface.filter[].enable lr_param.add_interface.filter[].order",
    .needs = Needs::cycle_time,
    .check = interface_filter_time_fits,
};

}  // namespace axisc::validator::checks::ax3051
