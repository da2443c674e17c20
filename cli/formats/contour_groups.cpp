#include "cli/formats/contour_groups.hpp"

#include "cli/failure.hpp"
#include "cli/files/path_machine.hpp"
#include "cli/sentences.hpp"
#include "motion/chain_answer.hpp"
#include "motion/feed_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::cli {

namespace {

/// One group's chains, switched by the given commands.
class GroupChains {
 public:
  GroupChains(machine::Machine machine, std::size_t group, std::vector<machine::FilterCommand> commands,
              std::string path)
      : machine_(std::move(machine)), group_(group), commands_(std::move(commands)), path_(std::move(path)) {
    for (auto const& command : commands_) add_set(command.parameters);
  }

  /// Orders that answers() accepts.
  void add_order(std::uint32_t order) {
    auto parameters = commands_.front().parameters;
    parameters.order = order;
    add_set(parameters);
  }

  [[nodiscard]] std::vector<motion::ChainAnswer> answers(std::optional<std::uint32_t> order) {
    if (!runtime_) runtime_.emplace(group_runtime(image_of(machine_, path_), group(), path_));
    static_cast<void>(runtime_->reset({}));
    for (auto command : commands_) {
      if (order && !command.hsc) command.parameters.order = order;
      static_cast<void>(runtime_->command(command));
    }
    auto answered = motion::chain_answers(*runtime_);
    if (auto const* const missing = std::get_if<motion::NoAnswer>(&answered)) {
      throw Failure({.sentence = says::blocks_constant,
                     .arguments = {{"axis", machine_.axes[group().axes[missing->axis]].name},
                                   {"group", group().name}}});
    }
    return std::get<std::vector<motion::ChainAnswer>>(std::move(answered));
  }

  [[nodiscard]] machine::MachineGroup const& group() const { return machine_.groups[group_]; }
  [[nodiscard]] machine::Machine const& machine() const { return machine_; }

 private:
  void add_set(machine::FilterParameters const& parameters) {
    auto& sets = machine_.groups[group_].filter_sets;
    if (parameters.empty() || std::find(sets.begin(), sets.end(), parameters) != sets.end()) return;
    sets.push_back(parameters);
  }

  machine::Machine machine_;
  std::size_t group_;
  std::vector<machine::FilterCommand> commands_;
  std::string path_;
  std::optional<motion::GroupRuntime> runtime_;
};

/// Position units per NC cycle.
double velocity_of(double feed_mm_per_min, design::CycleTime cycle_time) {
  return feed_mm_per_min / 60 * cycle_time.seconds() * motion::units_per_mm;
}

bool synchronous(std::vector<motion::ChainAnswer> const& answers) {
  return std::all_of(answers.begin(), answers.end(), [&](motion::ChainAnswer const& answer) {
    return std::abs(answer.delay - answers.front().delay) < 1e-6;
  });
}

/// The largest order that keeps the tolerance at the first feed: all of them are tried, because the width of the windowed
/// sinc follows its cut-off frequency and not its order.
std::optional<std::uint32_t> allowed_order(GroupChains& chains, std::uint32_t highest, double velocity,
                                           double turn, double tolerance) {
  for (std::uint32_t order = highest; order > 0; --order) {
    auto const figures = motion::predict_corner(chains.answers(order), velocity, turn);
    if (figures.largest_axis_error() <= tolerance) return order;
  }
  return std::nullopt;
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
  auto const cycle_time = chains.machine().cycle_time;
  double const turn = wanted.angle_deg * std::numbers::pi / 180;
  double const radius = wanted.radius_mm * motion::units_per_mm;
  auto const highest = wanted.tolerance_mm ? highest_order(chains.machine(), chains.group()) : 0;
  for (auto const& order : wanted.orders) {
    if (order) chains.add_order(*order);
  }
  for (std::uint32_t order = 1; order <= highest; ++order) chains.add_order(order);

  GroupContour found{.name = chains.group().name, .axes = {}, .cases = {}, .limits = {}};
  for (auto const axis : chains.group().axes) found.axes.push_back(chains.machine().axes[axis].name);
  for (double const feed : wanted.feeds) {
    double const velocity = velocity_of(feed, cycle_time);
    for (auto const& order : wanted.orders) {
      auto const answers = chains.answers(order);
      found.synchronous = found.synchronous && synchronous(answers);
      found.cases.push_back({.feed_mm_per_min = feed,
                             .order = order,
                             .corner = motion::predict_corner(answers, velocity, turn),
                             .circle = motion::predict_circle(answers, velocity, radius),
                             .line = motion::predict_line(answers, velocity),
                             .parallel = motion::predict_parallel(answers, velocity)});
    }
  }
  if (!wanted.tolerance_mm) return found;
  double const tolerance = *wanted.tolerance_mm * motion::units_per_mm;
  auto const answers = chains.answers(wanted.orders.front());
  auto const feed_of = [&](std::optional<double> const& velocity) -> std::optional<double> {
    if (!velocity) return std::nullopt;
    return *velocity / velocity_of(1, cycle_time);
  };
  found.limits = ContourLimits{
      .tolerance_mm = *wanted.tolerance_mm,
      .corner_feed = feed_of(motion::corner_velocity(answers, turn, tolerance)),
      .circle_feed = feed_of(motion::circle_velocity(answers, radius, tolerance)),
      .order = allowed_order(chains, highest, velocity_of(wanted.feeds.front(), cycle_time), turn, tolerance),
      .has_order = highest > 0};
  return found;
}

}  // namespace axisc::cli
