#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/guards.hpp"

namespace axisc::validator::checks::ax3029::says {

constexpr Sentence unused{
    "this list sets the Vibration Guard, but neither the list nor a program of the machine switches it on",
    "diese Liste stellt den Vibration Guard ein, aber weder die Liste noch ein Programm der Maschine "
    "schaltet ihn ein"};
constexpr Sentence switch_on{
    "`vib_guard.active 1` switches it on, `#VIB GUARD ON` for all axes of the channel",
    "`vib_guard.active 1` schaltet ihn ein, `#VIB GUARD ON` für alle Achsen des Kanals"};

}  // namespace axisc::validator::checks::ax3029::says

namespace axisc::validator::checks::ax3029 {
namespace {

void guard_unused(AxisContext const& axis, Report& report) {
  GuardView const& guard = axis.guard;
  if (guard.active.unusable || guard.is_active()) return;
  EffectiveValue const* set = nullptr;
  for (EffectiveValue const* const value : {&guard.mode, &guard.frequency, &guard.damping}) {
    if (set == nullptr && value->set()) set = value;
  }
  if (set == nullptr || commands_guard(axis.machine)) return;
  Finding& finding = report.add(*set, {says::unused, {}});
  finding.help.push_back({says::switch_on, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "vib_guard.*",
    .check = guard_unused,
};

}  // namespace axisc::validator::checks::ax3029
