#include "axisc/answers/figures/axis_delays.hpp"

#include "axisc/answers/execution/port_response.hpp"
#include "design/filter_analysis.hpp"
#include "design/kernels/kernel_analysis.hpp"

#include <cmath>
#include <utility>

namespace axisc::says {

constexpr Sentence delay_before{"{axis}, before", "{axis}, vorher"};
constexpr Sentence delay_kernel{"FIR/HSC filter", "FIR-/HSC-Filter"};
constexpr Sentence delay_guard{"Vibration Guard", "Vibration Guard"};
constexpr Sentence delay_interpolator{"interpolator to position controller", "Interpolator bis Lageregler"};
constexpr Sentence delay_lag{"lag of the position controller", "Nachlauf des Lagereglers"};
constexpr Sentence delay_drive{"in the drive", "im Antrieb"};
constexpr Sentence delay_velocity{"{axis}, v", "{axis}, v"};

}  // namespace axisc::says

namespace axisc {
namespace {

/// Of the kernel in ms: of what --at switched on, else of the listed one, which programs switch on.
double kernel_delay(PlotSubject const& subject, PlottedImage const& image, std::size_t axis,
                    double filters_ms) {
  auto const& contents = image.contents();
  if (subject.is_switched) {
    PortResponse const response(contents, image.host, axis, Port::setpoint);
    // A kernel that is off leaves what the sum was rounded by.
    constexpr double nothing_ms = 1e-9;
    double const rest = response.at({0}).group_delay_s * 1e3 - filters_ms;
    return std::abs(rest) < nothing_ms ? 0 : rest;
  }
  auto const& listed = contents.axes[axis].slot->kernel;
  if (!listed) return 0;
  return design::kernel_response(contents.kernels[*listed].design, {0}, contents.cycle_time).group_delay_s *
         1e3;
}

std::string name_of(PlotSubject const& subject, machine::DriveDelay const& delay) {
  switch (delay.kind) {
    case machine::DelayKind::interpolator: return subject.say(says::delay_interpolator);
    case machine::DelayKind::lag: return subject.say(says::delay_lag);
    case machine::DelayKind::drive: return subject.say(says::delay_drive);
    case machine::DelayKind::filter:
    case machine::DelayKind::shift:
    case machine::DelayKind::quantity:
    case machine::DelayKind::balancing: break;
  }
  return delay.parameter;
}

void add_share(AxisDelay& delay, std::string name, double milliseconds) {
  if (delay.at_start) *delay.at_start += milliseconds;
  delay.total += milliseconds;
  delay.shares.push_back({.name = std::move(name), .milliseconds = milliseconds});
}

/// What delays the position after the filters, where the machine is known.
void add_drive_path(PlotSubject const& subject, PlottedImage const& image, std::size_t axis,
                    AxisDelay& delay) {
  if (image.machine == nullptr) return;
  double const cycle_ms = image.contents().cycle_time.microseconds() / 1e3;
  for (auto const& one : image.machine->axes[axis].drive_path.delays) {
    if (one.position != 0) add_share(delay, name_of(subject, one), one.position * cycle_ms);
  }
}

/// Of the velocity that is fed forward: computed from the filtered setpoint. `filters` are the shares of the
/// filters in the position, in their order, those of filter[i] first. None where it is not fed forward.
std::optional<AxisDelay> velocity_delay(PlotSubject const& subject, PlottedImage const& image,
                                        std::size_t axis, AxisDelay const& position) {
  if (image.machine == nullptr) return std::nullopt;
  auto const& path = image.machine->axes[axis].drive_path;
  if (!path.feeds_velocity) return std::nullopt;
  auto const& compiled = image.contents().axes[axis];
  AxisDelay delay{.name = subject.say(says::delay_velocity, {{"axis", position.name}}), .shares = {}};
  if (position.at_start) delay.at_start = 0;
  std::size_t const filters = compiled.filters.size() + (compiled.slot ? 1 : 0);
  for (std::size_t i = 0; i < filters; ++i) {
    bool const is_last = i + 1 == compiled.filters.size();
    bool const is_of_position = is_last && path.delays_position_alone &&
                                compiled.filters[i].specification.type == design::FilterType::time_delay;
    if (is_of_position) continue;
    auto const& share = position.shares[i];
    double const at_start = delay.at_start.value_or(0);
    add_share(delay, share.name, share.milliseconds);
    if (delay.at_start && i >= compiled.filters.size()) delay.at_start = at_start;
  }
  double const cycle_ms = image.contents().cycle_time.microseconds() / 1e3;
  for (auto const& one : path.delays) {
    if (one.velocity != 0) add_share(delay, name_of(subject, one), one.velocity * cycle_ms);
  }
  return delay;
}

AxisDelay delay_of(PlotSubject const& subject, PlottedImage const& image, std::size_t axis,
                   std::string name) {
  auto const& contents = image.contents();
  AxisDelay delay{.name = std::move(name), .shares = {}};
  for (auto const& filter : contents.axes[axis].filters) {
    double const share =
        design::chain_response({&filter.design, 1}, {0}, contents.cycle_time).group_delay_s * 1e3;
    delay.shares.push_back({.name = filter_label(filter, subject.language), .milliseconds = share});
    delay.total += share;
  }
  if (auto const& slot = contents.axes[axis].slot) {
    double const kernel = kernel_delay(subject, image, axis, delay.total);
    if (!subject.is_switched && !slot->on_at_start && kernel != 0) delay.at_start = delay.total;
    bool const is_guard = slot->family == machine::KernelFamily::guard;
    delay.shares.push_back(
        {.name = subject.say(is_guard ? says::delay_guard : says::delay_kernel), .milliseconds = kernel});
    delay.total += kernel;
  }
  add_drive_path(subject, image, axis, delay);
  return delay;
}

}  // namespace

std::vector<DelayPair> delays_of(PlotSubject const& subject) {
  std::vector<DelayPair> delays;
  for (auto const axis : subject.axes) {
    DelayPair position;
    DelayPair velocity;
    if (auto const old = subject.axis_before(axis)) {
      position.was = delay_of(subject, *subject.before, *old,
                              subject.say(says::delay_before, {{"axis", subject.name(axis)}}));
      velocity.was = velocity_delay(subject, *subject.before, *old, *position.was);
    }
    position.is = delay_of(subject, subject.now, axis, subject.name(axis));
    velocity.is = velocity_delay(subject, subject.now, axis, *position.is);
    delays.push_back(std::move(position));
    if (velocity.was || velocity.is) delays.push_back(std::move(velocity));
  }
  return delays;
}

}  // namespace axisc
