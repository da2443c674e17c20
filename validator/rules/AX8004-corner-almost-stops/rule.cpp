#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/views/axis_dynamics.hpp"

#include <algorithm>
#include <limits>

namespace axisc::validator::checks::ax8004::says {

constexpr Sentence headline{"through a corner of 90° the path moves with {velocity} mm/s",
                            "durch eine Ecke von 90° fährt die Bahn mit {velocity} mm/s"};
constexpr Sentence weight{
    "P-AXIS-00013 (`a_trans_weight`) is 0 in axis \"{axis}\": its velocity may change by a T²/tr from one "
    "cycle to the next",
    "P-AXIS-00013 (`a_trans_weight`) ist 0 in Achse „{axis}“: ihre Geschwindigkeit darf sich von einem "
    "Zyklus zum nächsten um a T²/tr ändern"};
constexpr Sentence help{
    "with `getriebe[0].dynamik.a_trans_weight 1000` it would be {velocity} mm/s; the step excites the "
    "machine more",
    "mit `getriebe[0].dynamik.a_trans_weight 1000` wären es {velocity} mm/s; der Sprung regt die Maschine "
    "stärker an"};

}  // namespace axisc::validator::checks::ax8004::says

namespace axisc::validator::checks::ax8004 {
namespace {

/// What an axis contributes to a corner between it and another one.
struct AxisCorner {
  double velocity = std::numeric_limits<double>::infinity();  ///< mm/s
  double weighted = std::numeric_limits<double>::infinity();  ///< with the weight 1000
};

/// v |u1 - u0| ≤ w a T with |u1 - u0| = 1, w = T/tr for the weight 0.
AxisCorner corner_of(machine::AxisDynamics const& dynamics, double T) {
  machine::MotionDynamics const& feed = dynamics.feed;
  double const a = std::min(feed.up.acceleration, feed.down.acceleration);
  double const tr =
      std::max({feed.up.build_up, feed.up.take_back, feed.down.build_up, feed.down.take_back}) * 1e-6;
  return {.velocity = a * T * std::min(T / tr, 1.0), .weighted = a * T};
}

void corner_almost_stops(GroupContext const& context, Report& report) {
  LoadedGroup const& group = context.group;
  bool const weighs = group.dynamics.slope != machine::Slope::step && group.dynamics.transition_mode != 2;
  if (!group.slope_place || !weighs) return;
  double const T = context.whole.cycle_time.seconds();
  AxisCorner lowest;
  LoadedAxis const* slowest = nullptr;
  for (std::size_t const index : group.axes) {
    LoadedAxis const& axis = context.whole.machine.axes[index];
    auto const dynamics = axis_dynamics(axis.merged.values);
    auto const corner = corner_of(dynamics, T);
    if (dynamics.acceleration_transition_weight != 0 || corner.velocity >= lowest.velocity) continue;
    lowest = corner;
    slowest = &axis;
  }
  if (slowest == nullptr) return;
  constexpr int digits = 2;
  Finding& finding = report.add(
      *group.slope_place, message(says::headline, {{"velocity", format_rounded(lowest.velocity, digits)}}));
  finding.notes.push_back(message(says::weight, {{"axis", slowest->name}}));
  finding.help.push_back(message(says::help, {{"velocity", format_rounded(lowest.weighted, digits)}}));
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "getriebe[].dynamik.a_trans_weight",
    .needs = Needs::cycle_time,
    .check = corner_almost_stops,
};

}  // namespace axisc::validator::checks::ax8004
