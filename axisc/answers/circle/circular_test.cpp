#include "axisc/answers/circle/circular_test.hpp"

#include "analysis/motion/contour/position_delays.hpp"
#include "analysis/motion/point.hpp"
#include "axisc/asked/plane.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"
#include "diagnostics/format_number.hpp"
#include "image/chain_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace axisc::says {

constexpr Sentence no_two_axes{"{machine} has no two linear axes in a channel: there is no circle",
                               "{machine} hat keine zwei Linearachsen in einem Kanal: Es gibt keinen Kreis"};
constexpr Sentence needs_circle{"without a recording, a circle needs --feed and --radius",
                                "ohne Aufzeichnung braucht ein Kreis --feed und --radius"};
constexpr Sentence needs_plane{
    "the machine has several pairs of linear axes; name the one of the circle with --plane",
    "die Maschine hat mehrere Paare von Linearachsen; das des Kreises mit --plane nennen"};
constexpr Sentence one_feed{"a recording has one feed; give one with --feed, or none",
                            "eine Aufzeichnung hat einen Vorschub; mit --feed einen angeben oder keinen"};
constexpr Sentence of_recording{
    "--external, --setpoint and --actual are about a recording; name one",
    "--external, --setpoint und --actual betreffen eine Aufzeichnung; eine nennen"};
constexpr Sentence of_scope{
    "--setpoint and --actual name columns of a scope, and --external a measuring instrument's file",
    "--setpoint und --actual nennen Spalten eines Scopes, --external die Datei eines Messgeräts"};
constexpr Sentence not_recorded{
    "--{option} {given}: the recorded circle has {recorded} {unit}; leave the option out, or give that",
    "--{option} {given}: der aufgezeichnete Kreis hat {recorded} {unit}; die Option weglassen oder das "
    "angeben"};
constexpr Sentence too_fast{
    "at {feed} mm/min a circle of {radius} mm takes less than two NC cycles; lower the feed",
    "bei {feed} mm/min dauert ein Kreis von {radius} mm weniger als zwei NC-Zyklen; den Vorschub verringern"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr Code unlike_delays{4011};
constexpr double seconds_per_minute = 60;
/// Of --feed and --radius from what was recorded.
constexpr double largest_departure = 0.01;

bool is_linear(machine::AxisConfiguration const& axis) {
  return axis.type == machine::AxisType::translatory && !axis.gantry_master;
}

std::vector<std::size_t> linear_axes(machine::Machine const& machine, std::size_t group) {
  auto axes = machine.groups[group].axes;
  std::erase_if(axes, [&](std::size_t axis) { return !is_linear(machine.axes[axis]); });
  return axes;
}

/// Each pair of linear axes of a channel.
std::vector<Plane> planes_in(machine::Machine const& machine, std::size_t group) {
  auto const axes = linear_axes(machine, group);
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (std::size_t k = i + 1; k < axes.size(); ++k) planes.push_back({axes[i], axes[k]});
  }
  return planes;
}

std::vector<Plane> planes_of(CircleMachine const& machine, std::optional<std::string> const& word) {
  std::vector<Plane> planes;
  std::vector<std::string> names;
  std::vector<std::size_t> linear;
  for (std::size_t group = 0; group < machine.machine.groups.size(); ++group) {
    for (auto const axis : linear_axes(machine.machine, group)) {
      linear.push_back(axis);
      names.push_back(machine.machine.axes[axis].name);
    }
    for (auto const& plane : planes_in(machine.machine, group)) planes.push_back(plane);
  }
  if (word) {
    auto const [u, v] = asked_plane(*word, names);
    return {{linear[u], linear[v]}};
  }
  if (planes.empty()) throw Failure({says::no_two_axes, {{"machine", machine.path}}});
  return planes;
}

double angular_speed(double feed, double radius_mm) {
  return feed / seconds_per_minute / radius_mm;
}

/// Less than two NC cycles a turn.
bool is_too_fast(CircleMachine const& machine, double feed, double radius_mm) {
  return angular_speed(feed, radius_mm) * machine.machine.cycle_time.seconds() >= std::numbers::pi;
}

CircleCase predicted(CircleMachine const& machine, Plane const& plane, double feed, double radius_mm) {
  CircleCase one;
  one.feed_mm_per_min = feed;
  one.radius_mm = radius_mm;
  double const omega = angular_speed(feed, radius_mm);
  if (is_too_fast(machine, feed, radius_mm)) {
    throw Failure(
        {says::too_fast, {{"feed", format_rounded(feed, 6)}, {"radius", format_rounded(radius_mm, 6)}}});
  }
  std::vector<machine::PositionDelay> later;
  for (auto const axis : plane) {
    later.push_back(machine::position_delay(machine.machine.axes[axis].drive_path));
  }
  later = motion::unequal_delays(later);
  later.resize(plane.size());
  for (std::size_t i = 0; i < plane.size(); ++i) {
    one.axes.at(i) = machine.machine.axes[plane.at(i)].name;
    if (blocks_constant(machine.image.axes[plane.at(i)])) {
      throw Failure({says::blocks_constant, {{"axis", one.axes.at(i)}, {"group", machine.path}}});
    }
    one.filtered.at(i) = filtered_axis(machine.image, plane.at(i), later[i], omega);
  }
  one.predicted = {.radius = radius_mm * motion::um_per_mm,
                   .gain_u = one.filtered[0].gain(),
                   .gain_v = one.filtered[1].gain(),
                   .phase = omega * one.delay_difference_s()};
  one.deviations = one.predicted.deviations();
  return one;
}

/// Until the filters of both axes have forgotten how the circle began.
double settling_s(ImageFile const& image, Plane const& plane) {
  std::uint64_t cycles = 0;
  for (auto const& figures : image::chain_figures(image.bytes.bytes(), image.contents, plane)) {
    cycles = std::max(cycles, figures.settling_cycles.value_or(image::longest_settling));
  }
  std::size_t taps = 0;
  for (auto const axis : plane) {
    auto const& slot = image.contents.axes[axis].slot;
    if (slot && slot->kernel) taps = std::max(taps, image.contents.kernels[*slot->kernel].design.taps.size());
  }
  return static_cast<double>(cycles + taps) * image.contents.cycle_time.seconds();
}

void compare(std::string const& option, double given, double recorded, std::string const& unit) {
  if (std::abs(given - recorded) <= largest_departure * recorded) return;
  throw Failure({says::not_recorded,
                 {{"option", option},
                  {"given", format_rounded(given, 6)},
                  {"recorded", format_rounded(recorded, 6)},
                  {"unit", unit}}});
}

/// Columns are named for the axes of a circle.
void refuse_foreign_axes(CircleMachine const& machine, std::vector<Plane> const& planes,
                         RecordedCircleQuestion const& wanted) {
  std::vector<std::string> axes;
  for (auto const& plane : planes) {
    for (auto const axis : plane) {
      auto const& name = machine.machine.axes[axis].name;
      if (std::find(axes.begin(), axes.end(), name) == axes.end()) axes.push_back(name);
    }
  }
  for (auto const* const named : {&wanted.setpoints, &wanted.actuals}) {
    for (auto const& each : *named) {
      if (std::find(axes.begin(), axes.end(), each.axis) == axes.end()) throw unknown_axis(each.axis, axes);
    }
  }
}

CircleCase recorded(CircleMachine const& machine, ImageFile const& image, CircleQuestion const& question) {
  std::vector<RecordingFile> files;
  for (auto const& path : question.recordings) files.push_back(open_recording(path));
  if (question.feeds.size() > 1) throw Failure({says::one_feed});
  auto wanted = question.recorded;
  wanted.radius_mm = question.radius_mm;
  if (!question.feeds.empty()) wanted.feed = question.feeds.front();
  auto const planes = planes_of(machine, question.plane);
  if (planes.size() > 1 && wanted.is_external) throw Failure({says::needs_plane});
  refuse_foreign_axes(machine, planes, wanted);
  auto const plane =
      planes.size() == 1 ? planes.front() : recorded_plane(machine, files.front(), wanted.actuals, planes);
  auto found = recorded_circle(machine, plane, files, wanted, settling_s(image, plane));
  double const radius_mm = found.radius / motion::um_per_mm;
  double const feed = found.feed_mm_per_min();
  if (question.radius_mm) compare("radius", *question.radius_mm, radius_mm, "mm");
  if (wanted.feed) compare("feed", *wanted.feed, feed, "mm/min");
  auto one = predicted(machine, plane, feed, radius_mm);
  one.recorded = std::move(found);
  return one;
}

}  // namespace

double CircleCase::delay_difference_s() const {
  return filtered[0].delay_s() - filtered[1].delay_s();
}

double CircleCase::deviation() const {
  auto const& figures = recorded ? recorded->deviations : deviations;
  if (figures.bidirectional) return *figures.bidirectional;
  return figures.counterclockwise ? *figures.counterclockwise : figures.clockwise.value_or(0);
}

bool CircularTest::keeps(CircleCase const& one) const {
  return !tolerance_um || one.deviation() <= *tolerance_um;
}

bool CircularTest::keeps_tolerance() const {
  return std::all_of(cases.begin(), cases.end(), [this](CircleCase const& one) { return keeps(one); });
}

Overrides with_unlike_delays(Overrides overrides) {
  overrides.options.severities[unlike_delays] = Severity::warning;
  return overrides;
}

CircularTest channel_circles(CircleMachine const& machine, std::size_t group, double feed, double radius_mm) {
  CircularTest test{.cycle_time = machine.machine.cycle_time, .cases = {}, .tolerance_um = {}, .files = {}};
  if (is_too_fast(machine, feed, radius_mm)) return test;
  for (auto const& plane : planes_in(machine.machine, group)) {
    test.cases.push_back(predicted(machine, plane, feed, radius_mm));
  }
  return test;
}

std::optional<CircularTest> circular_test(Workspace& workspace, CircleQuestion const& question,
                                          ErrorSink const& errors) {
  bool const is_recorded = !question.recordings.empty();
  auto const& recorded_as = question.recorded;
  bool const names_columns = !recorded_as.setpoints.empty() || !recorded_as.actuals.empty();
  if (!is_recorded && (recorded_as.is_external || names_columns)) throw Failure({says::of_recording});
  if (recorded_as.is_external && names_columns) throw Failure({says::of_scope});
  if (!is_recorded && (question.feeds.empty() || !question.radius_mm)) throw Failure({says::needs_circle});
  auto checked = checked_machine(workspace, question.machine, errors);
  if (!checked) return std::nullopt;
  auto const image = image_of(checked->machine, question.machine.input);
  CircleMachine const machine{
      .path = question.machine.input, .machine = checked->machine, .image = image.contents};
  CircularTest test{.cycle_time = machine.machine.cycle_time,
                    .cases = {},
                    .tolerance_um = question.tolerance_um,
                    .files = std::move(checked->files)};
  test.files.insert(test.files.end(), question.recordings.begin(), question.recordings.end());
  if (is_recorded) {
    test.cases.push_back(recorded(machine, image, question));
    return test;
  }
  for (auto const& plane : planes_of(machine, question.plane)) {
    for (double const feed : question.feeds) {
      test.cases.push_back(predicted(machine, plane, feed, *question.radius_mm));
    }
  }
  return test;
}

}  // namespace axisc
