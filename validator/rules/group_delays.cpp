#include "validator/rules/group_delays.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/delay_budget.hpp"
#include "validator/views/gantry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace axisc::validator::checks {

namespace {

Wording cycles_text(double cycles) {
  return format_rounded(std::round(cycles * 1000) / 1000, 6);
}

}  // namespace

Delays delays_of(GroupContext const& context) {
  Delays delays;
  if (context.group.axes.size() < 2) return delays;
  for (std::size_t const index : context.group.axes) {
    LoadedAxis const& axis = context.whole.machine.axes[index];
    if (master_of(context.whole.machine, index)) continue;
    if (auto const delay = axis_delay(axis.merged.values, context.whole.cycle_time)) {
      delays.push_back({axis, *delay, delay_after_filters(axis, context.whole.cycle_time)});
    }
  }
  return delays;
}

Delays at_start(Delays delays) {
  for (DelayedAxis& axis : delays) axis.delay = validator::at_start(std::move(axis.delay));
  return delays;
}

bool less_delayed(DelayedAxis const& left, DelayedAxis const& right) {
  return left.delay.cycles < right.delay.cycles;
}

double spread(Delays const& delays) {
  if (delays.empty()) return 0;
  auto const [least, most] = std::minmax_element(delays.begin(), delays.end(), less_delayed);
  return most->delay.cycles - least->delay.cycles;
}

std::pair<DelayedAxis const*, DelayedAxis const*> extremes_after_filters(Delays const& delays) {
  if (delays.empty()) return {nullptr, nullptr};
  auto const less = [](DelayedAxis const& left, DelayedAxis const& right) {
    return left.after_filters < right.after_filters;
  };
  auto const [least, most] = std::minmax_element(delays.begin(), delays.end(), less);
  return {&*least, &*most};
}

std::optional<std::size_t> last_cause(Delays const& delays) {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < delays.size(); ++i) {
    EffectiveValue const* const cause = delays[i].delay.cause;
    if (cause == nullptr || !cause->value_place()) continue;
    if (!last || *delays[*last].delay.cause->value_place() < *cause->value_place()) last = i;
  }
  return last;
}

Wording counted_cycles(double cycles) {
  Wording const number = cycles_text(cycles);
  return number + (number == "1" ? Wording(" cycle", " Zyklus") : Wording(" cycles", " Zyklen"));
}

Message delay_of(DelayedAxis const& axis) {
  bool const none = axis.delay.shares.empty();
  return {none ? says::group_axis_delay : says::group_axis_shares,
          {{"axis", axis.axis.name},
           {"cycles", counted_cycles(axis.delay.cycles)},
           {"shares", shares_text(axis.delay)}}};
}

Message delay_after_filters_of(DelayedAxis const& axis) {
  return {says::group_axis_after_filters,
          {{"axis", axis.axis.name}, {"cycles", counted_cycles(axis.after_filters)}}};
}

EffectiveValue const* line_about_feedforward(LoadedAxis const& axis) {
  constexpr std::array<std::string_view, 5> parameters{
      "vorsteuer.vorsteuerung", "vorsteuer.default_active", "vorsteuer.global_disable",
      "vorsteuer.feedforward_without_delay", "vorsteuer.timeconst_sym_filter"};
  EffectiveValue const* last = nullptr;
  for (std::string_view const name : parameters) {
    EffectiveValue const& value = axis.merged.values.at(name);
    if (!value.value_place()) continue;
    if (last == nullptr || *last->value_place() < *value.value_place()) last = &value;
  }
  return last;
}

Wording shares_text(AxisDelay const& delay) {
  Wording text;
  for (DelayShare const& share : delay.shares) {
    text += (text.empty() ? "`" : ", `") + share.filter + "` " + cycles_text(share.cycles);
  }
  return text;
}

DelayShare const* largest_difference(AxisDelay const& axis, AxisDelay const& other) {
  DelayShare const* found = nullptr;
  double largest = 0;
  for (std::size_t i = axis.shares.size(); i-- > 0;) {
    DelayShare const& share = axis.shares[i];
    if (!share.cause->value_place()) continue;
    auto const same = std::find_if(other.shares.begin(), other.shares.end(),
                                   [&](DelayShare const& known) { return known.filter == share.filter; });
    double const difference = std::abs(share.cycles - (same == other.shares.end() ? 0 : same->cycles));
    if (found != nullptr && difference <= largest) continue;
    found = &share;
    largest = difference;
  }
  return found;
}

void relate_others(Finding& finding, Delays const& delays, std::size_t reported) {
  std::set<Place> known{*finding.place};
  for (std::size_t i = 0; i < delays.size(); ++i) {
    EffectiveValue const* const cause = delays[i].delay.cause;
    if (i == reported || cause == nullptr || !cause->value_place()) continue;
    if (known.insert(*cause->value_place()).second) {
      finding.related.push_back({*cause->value_place(), delay_of(delays[i])});
    }
  }
}

}  // namespace axisc::validator::checks
