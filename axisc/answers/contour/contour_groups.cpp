#include "axisc/answers/contour/contour_groups.hpp"

#include "analysis/motion/chain_answer.hpp"
#include "analysis/motion/feed_limits.hpp"
#include "axisc/answers/execution/group_chains.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc {

namespace {

bool synchronous(std::vector<motion::ChainAnswer> const& answers) {
  return std::all_of(answers.begin(), answers.end(), [&](motion::ChainAnswer const& answer) {
    return std::abs(answer.delay - answers.front().delay) < 1e-6;
  });
}

/// The largest order that keeps the tolerance at the first feed: all of them are tried, because the width of
/// the windowed sinc follows its cut-off frequency and not its order.
std::optional<std::uint32_t> allowed_order(GroupChains& chains, std::uint32_t highest, double velocity,
                                           double turn, double tolerance) {
  for (std::uint32_t order = highest; order > 0; --order) {
    auto const figures = motion::predict_corner(chains.answers(order), velocity, turn);
    if (figures.largest_axis_error() <= tolerance) return order;
  }
  return std::nullopt;
}

double acceleration_factor(std::vector<machine::FilterCommand> const& commands) {
  double factor = 1;
  for (auto const& command : commands) factor = command.acceleration_factor.value_or(factor);
  return factor;
}

/// Highest order that a command may give to all axes; 0 where none has a FIR filter.
std::uint32_t highest_order(machine::Machine const& machine, machine::MachineGroup const& group) {
  std::uint32_t highest = 0;
  bool delays = false;
  for (auto const axis : group.axes) {
    auto const& kernel = machine.axes[axis].kernel;
    if (!kernel || kernel->family != machine::KernelFamily::fir) continue;
    highest = design::longest_kernel_order;
    delays = delays || kernel->specification.type == design::KernelType::time_delay;
  }
  return delays ? std::min(highest, design::longest_kernel_delay) : highest;
}

}  // namespace

GroupContour predict_contour(ContourGroup const& group, ContourRequest const& wanted) {
  GroupChains chains(group.machine, group.group, group.commands, group.path);
  auto const cycle_time = group.machine.cycle_time;
  double const turn = wanted.angle_deg * std::numbers::pi / 180;
  double const radius = wanted.radius_mm * motion::units_per_mm;
  auto const highest =
      wanted.tolerance_mm && wanted.tries_orders ? highest_order(group.machine, chains.group()) : 0;
  for (auto const& order : wanted.orders) {
    if (order) chains.add_order(*order);
  }
  for (std::uint32_t order = 1; order <= highest; ++order) chains.add_order(order);

  GroupContour found{.name = chains.group().name,
                     .axes = {},
                     .cases = {},
                     .passages = {},
                     .dynamics = path_dynamics(group.machine, chains.group()),
                     .acceleration_factor = acceleration_factor(group.commands),
                     .limits = {}};
  for (auto const axis : chains.group().axes) {
    found.axes.push_back(group.machine.axes[axis].name);
    found.position_delays.push_back(machine::position_delay(group.machine.axes[axis].drive_path));
  }
  for (double const feed : wanted.feeds) {
    double const velocity = path_velocity(feed, cycle_time);
    auto const planes = motion::pass_corner(
        found.dynamics, {.turn = turn, .feed = velocity, .acceleration_factor = found.acceleration_factor});
    auto const slowest =
        std::min_element(planes.begin(), planes.end(),
                         [](auto const& one, auto const& other) { return one.velocity < other.velocity; });
    found.passages.push_back({.feed_mm_per_min = feed, .passage = *slowest});
    for (auto const& order : wanted.orders) {
      auto const answers = chains.answers(order);
      found.synchronous = found.synchronous && synchronous(answers);
      found.cases.push_back({.feed_mm_per_min = feed,
                             .order = order,
                             .corner = motion::predict_corner(answers, velocity, turn),
                             .circle = motion::predict_circle(answers, velocity, radius),
                             .line = motion::predict_line(answers, velocity),
                             .parallel = motion::predict_parallel(answers, velocity),
                             .passed_corner = motion::predict_passage(answers, planes)});
    }
  }
  if (!wanted.tolerance_mm) return found;
  double const tolerance = *wanted.tolerance_mm * motion::units_per_mm;
  auto const answers = chains.answers(wanted.orders.front());
  auto const feed_of = [&](std::optional<double> const& velocity) -> std::optional<double> {
    if (!velocity) return std::nullopt;
    return *velocity / path_velocity(1, cycle_time);
  };
  found.limits =
      ContourLimits{.tolerance_mm = *wanted.tolerance_mm,
                    .corner_feed = feed_of(motion::corner_velocity(answers, turn, tolerance)),
                    .circle_feed = feed_of(motion::circle_velocity(answers, radius, tolerance)),
                    .order = allowed_order(chains, highest, path_velocity(wanted.feeds.front(), cycle_time),
                                           turn, tolerance),
                    .has_order = highest > 0};
  return found;
}

}  // namespace axisc
