// AX3022 to AX3024: the order of a FIR filter given as a time.
#include "validator/fir_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/kernel_checks.hpp"

#include <cmath>

namespace axisc::validator::checks {
namespace {

/// order_time decides the order: a list gives it, and no order.
bool uses_order_time(FirView const& fir) {
  if (!fir.configured() || fir.order.unusable || fir.order_time.unusable) return false;
  return !(fir.order.value.number > 0) && fir.order_time.value.number > 0;
}

bool is_too_short(FirView const& fir, design::CycleTime cycle_time) {
  return cycle_time.cycles({fir.order_time.value.number}) < 1;
}

bool is_too_long(FirView const& fir, design::CycleTime cycle_time) {
  return cycle_time.cycles({fir.order_time.value.number}) > fir.longest_order();
}

Message in_cycles(FirView const& fir, design::CycleTime cycle_time) {
  double const time = fir.order_time.value.number;
  return {Text::filter_time_in_cycles,
          {{"time", microseconds(time)},
           {"milliseconds", milliseconds(time)},
           {"cycles", number(cycle_time.cycles({time}))},
           {"cycle", microseconds(cycle_time.microseconds())}}};
}

}  // namespace

void fir_order_time_range(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (!uses_order_time(fir)) return;
  bool const short_one = is_too_short(fir, axis.cycle_time);
  if (!short_one && !is_too_long(fir, axis.cycle_time)) return;
  std::string const order = number(fir.longest_order());
  double const cycle = axis.cycle_time.microseconds();
  Finding& finding =
      report.add(fir.order_time, {short_one ? Text::ax3022_short : Text::ax3022_long, {{"order", order}}});
  finding.label = in_cycles(fir, axis.cycle_time);
  finding.notes.push_back({Text::ax3022_limit,
                           {{"p_axis", parameter_number(fir.order_time)},
                            {"order", order},
                            {"shortest", microseconds(cycle)},
                            {"longest", microseconds(cycle * fir.longest_order())}}});
  if (short_one) {
    react(finding, "50910", {Text::kernel_reaction_not_active, {}});
  } else {
    react(finding, "50911", {Text::ax3001_clipped, {}}, order);
  }
}

void fir_order_time_unused(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (!fir.configured() || fir.order.unusable || fir.order_time.unusable) return;
  if (!(fir.order.value.number > 0) || !(fir.order_time.value.number > 0)) return;
  Finding& finding = report.add(fir.order_time, {Text::ax3023, {{"order", number(fir.order.value.number)}}});
  finding.label = Message{Text::ax3023_label, {{"time", microseconds(fir.order_time.value.number)}}};
  if (fir.order.value_place()) {
    finding.related.push_back({*fir.order.value_place(), {Text::ax3023_order_here, {}}});
  }
  react(finding, "", {Text::ax3009_reaction, {}}, "filter_fir.order " + number(fir.order.value.number));
}

void fir_order_time_rounded(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (!uses_order_time(fir) || is_too_short(fir, axis.cycle_time) || is_too_long(fir, axis.cycle_time)) {
    return;
  }
  double const nanoseconds = fir.order_time.value.number * 1000;
  if (std::fmod(nanoseconds, axis.cycle_time.nanoseconds) == 0) return;
  std::string const order = number(fir.resulting_order(axis.cycle_time));
  Finding& finding = report.add(fir.order_time, {Text::ax3024, {{"order", order}}});
  finding.label = in_cycles(fir, axis.cycle_time);
  finding.notes.push_back({Text::ax3024_formula, {{"p_axis", parameter_number(fir.order_time)}}});
  react(finding, "", {Text::ax3024_reaction, {}}, order);
}

}  // namespace axisc::validator::checks
