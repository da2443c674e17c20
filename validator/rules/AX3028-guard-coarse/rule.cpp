#include "validator/engine/rule.hpp"

#include "design/kernels/vibration_guard.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/guards.hpp"
#include "validator/rules/helpers.hpp"

#include <optional>
#include <utility>

namespace axisc::validator::checks::ax3028::says {

constexpr Sentence coarse{
    "at its own frequency the Vibration Guard leaves {residual} % of the vibration",
    "der Vibration Guard lässt bei seiner eigenen Frequenz {residual} % der Schwingung übrig"};
constexpr Sentence of_axis{
    "at its own frequency the Vibration Guard of {axis} leaves {residual} % of the vibration",
    "der Vibration Guard von {axis} lässt bei seiner eigenen Frequenz {residual} % der Schwingung übrig"};
constexpr Sentence reason{
    "half a period has {cycles} cycles, between which impulses are split (a reading)",
    "eine halbe Periode hat {cycles} Zyklen, zwischen denen Impulse geteilt werden (eine "
    "Lesart)"};
constexpr Sentence band{"at most 5 % are left from {from} to {to} Hz",
                        "höchstens 5 % bleiben von {from} bis {to} Hz"};
constexpr Sentence no_band{"more than 5 % are left at every frequency around it",
                           "bei jeder Frequenz ringsum bleiben mehr als 5 %"};
constexpr Sentence help{
    "a low-pass or `BANDSTOP` in `filter[i]` suits such frequencies better",
    "ein Tiefpass oder `BANDSTOP` in `filter[i]` eignet sich für solche Frequenzen besser"};

}  // namespace axisc::validator::checks::ax3028::says

namespace axisc::validator::checks::ax3028 {
namespace {

void describe(Finding& finding, design::KernelDesign const& kernel, design::KernelSpecification const& guard,
              design::CycleTime cycle_time) {
  double const half_period = design::guard_impulses(guard)[1].time.value;
  finding.notes.push_back({says::reason, {{"cycles", number(cycle_time.cycles({half_period}))}}});
  auto const band = design::robustness(kernel, guard, cycle_time);
  finding.notes.push_back(
      band ? Message{says::band, {{"from", number(band->from.value)}, {"to", number(band->to.value)}}}
           : Message{says::no_band, {}});
  finding.help.push_back({says::help, {}});
}

/// The kernel and what it leaves; nothing where that is little, and where there is no kernel.
struct Coarse {
  design::KernelDesign kernel;
  double residual = 0;
};

std::optional<Coarse> coarse(design::KernelSpecification const& guard, design::CycleTime cycle_time) {
  if (!can_be_compiled(guard, cycle_time)) return std::nullopt;
  Coarse found{.kernel = design::design_kernel(guard, cycle_time)};
  found.residual = design::residual_at_design(found.kernel, guard, cycle_time);
  return found.residual > design::usual_residual ? std::optional(std::move(found)) : std::nullopt;
}

void guard_coarse(AxisContext const& axis, Report& report) {
  auto const guard = axis.guard.specification(axis.cycle_time);
  if (!axis.guard.is_active() || !guard) return;
  auto const found = coarse(*guard, axis.cycle_time);
  if (!found) return;
  Finding& finding = report.add(axis.guard.anchor(axis.guard.frequency),
                                {says::coarse, {{"residual", percent(found->residual)}}});
  describe(finding, found->kernel, *guard, axis.cycle_time);
}

void in_program(ProgramContext const& context, Report& report) {
  for (CommandedGuard const& commanded : commanded_guards(context)) {
    auto const found = coarse(commanded.guard, context.whole.cycle_time);
    if (!found) continue;
    Finding& finding = report.add(
        commanded.place,
        {says::of_axis, {{"axis", std::string(commanded.axis)}, {"residual", percent(found->residual)}}});
    describe(finding, found->kernel, commanded.guard, context.whole.cycle_time);
    return;
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "vib_guard.*",
    .needs = Needs::cycle_time,
    .check = guard_coarse,
    .program_check = in_program,
};

}  // namespace axisc::validator::checks::ax3028
