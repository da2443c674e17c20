#include "validator/engine/rule.hpp"

#include "design/kernels/vibration_guard.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/guards.hpp"
#include "validator/rules/helpers.hpp"

#include <cmath>

namespace axisc::validator::checks::ax3027::says {

constexpr Sentence slow{"the last impulse of the Vibration Guard comes after {cycles} cycles",
                        "der letzte Impuls des Vibration Guard kommt nach {cycles} Zyklen"};
constexpr Sentence of_axis{"the last impulse of the Vibration Guard of {axis} comes after {cycles} cycles",
                           "der letzte Impuls des Vibration Guard von {axis} kommt nach {cycles} Zyklen"};
constexpr Sentence limit_unknown{
    "how long a guard may be is not documented; FIR filters end at {limit} cycles (a reading)",
    "wie lang ein Vibration Guard sein darf, ist nicht dokumentiert; FIR-Filter enden bei {limit} Zyklen "
    "(eine Lesart)"};
constexpr Sentence too_long{"axisc compiles guards of up to {limit} cycles",
                            "axisc kompiliert Vibration Guards bis {limit} Zyklen"};
constexpr Sentence lowest{"in mode {mode} {frequency} Hz or more come within {limit} cycles",
                          "in Modus {mode} kommen {frequency} Hz und mehr mit {limit} Zyklen aus"};
constexpr Sentence reaction{
    "it may stop the motion, because it finds no guard for these values",
    "sie hält womöglich die Bewegung an, weil sie für diese Werte keinen Vibration Guard "
    "findet"};

}  // namespace axisc::validator::checks::ax3027::says

namespace axisc::validator::checks::ax3027 {
namespace {

void describe(Finding& finding, design::KernelSpecification const& guard, design::CycleTime cycle_time) {
  bool const fits = can_be_compiled(guard, cycle_time);
  double const limit = fits ? design::longest_usual_guard : design::longest_guard;
  if (fits) finding.severity = Severity::note;
  finding.notes.push_back({fits ? says::limit_unknown : says::too_long, {{"limit", number(limit)}}});
  double const lowest = design::lowest_guard_frequency(guard, cycle_time, limit).value;
  finding.help.push_back({says::lowest,
                          {{"mode", std::to_string(guard.order)},
                           {"frequency", number(std::ceil(lowest * 100) / 100)},
                           {"limit", number(limit)}}});
  react(finding, {says::reaction, {}});
}

bool is_slow(design::KernelSpecification const& guard, design::CycleTime cycle_time) {
  return design::guard_length(guard, cycle_time) > design::longest_usual_guard;
}

Wording cycles_of(design::KernelSpecification const& guard, design::CycleTime cycle_time) {
  return number(std::round(design::guard_length(guard, cycle_time)));
}

void guard_too_slow(AxisContext const& axis, Report& report) {
  auto const guard = axis.guard.specification(axis.cycle_time);
  if (!axis.guard.is_active() || !guard || !is_slow(*guard, axis.cycle_time)) return;
  Finding& finding = report.add(axis.guard.anchor(axis.guard.frequency),
                                {says::slow, {{"cycles", cycles_of(*guard, axis.cycle_time)}}});
  describe(finding, *guard, axis.cycle_time);
}

void in_program(ProgramContext const& context, Report& report) {
  design::CycleTime const cycle_time = context.whole.cycle_time;
  for (CommandedGuard const& found : commanded_guards(context)) {
    if (!is_slow(found.guard, cycle_time)) continue;
    Finding& finding = report.add(
        found.place,
        {says::of_axis, {{"axis", std::string(found.axis)}, {"cycles", cycles_of(found.guard, cycle_time)}}});
    describe(finding, found.guard, cycle_time);
    return;
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = "50820",
    .parameters = "vib_guard.*",
    .needs = Needs::cycle_time,
    .check = guard_too_slow,
    .program_check = in_program,
};

}  // namespace axisc::validator::checks::ax3027
