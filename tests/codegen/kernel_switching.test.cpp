// Switching linear-phase filters at full velocity: the bounds that are promised at axisrt_command.
#include "codegen/fade.hpp"
#include "codegen/image_writer.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace axisc::codegen::kernel_switching_test {
namespace {

using design::FilterSpecification;
using design::FilterType;
using design::KernelType;

constexpr std::size_t axes = 5;

/// FIR filters of three kinds, alone and behind a low-pass that overshoots, and NoVib in front of a
/// band-stop.
machine::Machine switching_machine() {
  machine::Machine machine;
  machine.cycle_time = {1'000'000};
  machine.axes.resize(axes);
  for (machine::AxisConfiguration& axis : machine.axes) {
    axis.velocity_limit = 500'000;
    axis.acceleration_limit = 8000;
  }
  FilterSpecification const low_pass{.type = FilterType::lowpass,
                                     .prototype = design::Prototype::butterworth,
                                     .order = 4,
                                     .frequency = {60}};
  FilterSpecification const band_stop{.type = FilterType::bandstop,
                                      .prototype = design::Prototype::butterworth,
                                      .order = 2,
                                      .frequency = {45},
                                      .quality = 1.5};
  machine.axes[0].kernel = test::fir({.type = KernelType::moving_average, .order = 40}, true);
  machine.axes[1].filters = {{.index = 0, .specification = low_pass}};
  machine.axes[1].kernel = test::fir({.type = KernelType::gaussian, .order = 60}, true);
  machine.axes[2].kernel =
      test::fir({.type = KernelType::windowed_sinc, .order = 50, .frequency = {70}}, false);
  machine.axes[3].filters = {{.index = 1, .specification = band_stop}};
  machine.axes[3].kernel =
      machine::ConfiguredKernel{.family = machine::KernelFamily::hsc,
                                .index = 0,
                                .specification = {.type = KernelType::novib, .order = 1, .frequency = {40}},
                                .on_at_start = false};
  machine.axes[4].kernel = test::fir({.type = KernelType::time_delay, .order = 20}, true);
  machine.groups = {{.name = "channel",
                     .axes = {0, 1, 2, 3, 4},
                     .filter_sets = {test::filter_set(10), test::filter_set(90, 70), test::filter_set(0),
                                     test::filter_set(10, 70), test::filter_set(0, 70)}}};
  return machine;
}

/// Trapezoids: to a random velocity with the full acceleration, some time there, now and then to a stop.
class TrapezoidalMotion {
 public:
  TrapezoidalMotion(MotionLimits const& limits, std::uint64_t seed) : limits_(limits), random_(seed) {}

  double next() {
    if (hold_ == 0) {
      target_ = random_.below(4) == 0 ? 0 : limits_.velocity * (random_.below(2) == 0 ? 1.0 : -1.0);
      if (random_.below(4) == 0) target_ *= random_.unit();
      hold_ = 20 + static_cast<int>(random_.below(target_ == 0 ? 1500 : 300));
    }
    double const change = std::clamp(target_ - velocity_, -limits_.acceleration, limits_.acceleration);
    velocity_ += change;
    if (change == 0) --hold_;
    if (std::abs(position_) > 4e8 && position_ * velocity_ > 0) target_ = -target_;
    return position_ += velocity_;
  }
  [[nodiscard]] bool stands() const { return velocity_ == 0; }

 private:
  MotionLimits limits_;
  test::Random random_;
  double position_ = 1000;
  double velocity_ = 0;
  double target_ = 0;
  int hold_ = 0;
};

/// What an axis has put out lately, and the peak gain of what worked in that time.
struct Watched {
  double y1 = 1000, y2 = 1000;
  double peak_gain = 1;
  int since_change = 0;
};

class Watch {
 public:
  explicit Watch(image::ImageContents const& contents) : contents_(contents), watched_(axes) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      for (image::ImageFilter const& filter : contents.axes[axis].filters) filters_[axis] *= filter.peak_gain;
    }
  }

  /// The largest excess over the bounds, in ulps of setpoint or output, whichever is larger (as in the
  /// accuracy that axisrt_step states).
  void check(std::size_t axis, double x, double y, axisrt_axis_state const& state,
             MotionLimits const& limits) {
    Watched& watched = watched_[axis];
    double const gain = filters_[axis] * kernel_gain(state);
    bool const is_new = state.kernel != kernels_[axis];
    watched.since_change = is_new || state.fading != 0 ? 0 : watched.since_change + 1;
    // Differences reach two cycles back.
    watched.peak_gain = watched.since_change > 2 ? gain : std::max(watched.peak_gain, gain);
    double const share = watched.since_change > 2 ? 0 : 0.25;
    kernels_[axis] = state.kernel;

    double const largest = std::max(std::abs(x), std::abs(y));
    double const ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
    double const first = std::abs(y - watched.y1) - (watched.peak_gain + share) * limits.velocity;
    double const second =
        std::abs(y - 2 * watched.y1 + watched.y2) - (watched.peak_gain + share) * limits.acceleration;
    excess = std::max({excess, first / ulp, second / ulp});
    most_added = std::max(most_added, std::abs(y - watched.y1) / limits.velocity - watched.peak_gain);
    watched.y2 = watched.y1;
    watched.y1 = y;
  }

  double excess = -1e300;
  double most_added = -1;

 private:
  [[nodiscard]] double kernel_gain(axisrt_axis_state const& state) const {
    return state.kernel == AXISRT_NO_KERNEL ? 1 : contents_.kernels[state.kernel].peak_gain;
  }
  image::ImageContents const& contents_;
  std::vector<Watched> watched_;
  std::array<double, axes> filters_ = {1, 1, 1, 1, 1};
  std::array<std::uint32_t, axes> kernels_{};
};

axisrt_status random_command(image::RuntimeHost& runtime, machine::Machine const& machine,
                             test::Random& random) {
  machine::FilterCommand command;
  std::uint32_t const kind = random.below(10);
  if (kind == 0) return runtime.end_program(0);
  command.filter_switch = kind <= 3 ? machine::FilterSwitch::off : machine::FilterSwitch::on;
  if (kind == 9) command.filter_switch = machine::FilterSwitch::unchanged;
  std::uint32_t const set = random.below(5);
  if (set < 3) command.parameters = machine.groups[0].filter_sets[set];
  command.hsc = set == 4;
  return runtime.command(0, command);
}

}  // namespace

namespace {

void switch_often(int number_of_commands) {
  machine::Machine const machine = switching_machine();
  std::vector<std::byte> const image = write_image(machine, {});
  image::ImageContents const contents = test::contents_of(image);
  for (image::ImageBank const& bank : contents.groups[0].banks) CHECK(bank.fade_cycles > 0);
  image::RuntimeHost runtime = test::runtime_for(image);
  CHECK(runtime.reset_all(1000) == AXISRT_OK);

  MotionLimits const limits = motion_limits(500'000, 8000, machine.cycle_time);
  TrapezoidalMotion motion(limits, 21);
  Watch watch(contents);
  test::Random random(22);
  std::array<double, axes> outputs{};
  int commands = 0;
  int accepted_in_motion = 0;
  int accepted_at_rest = 0;
  int stands_since = 0;
  bool stood = true;
  while (commands < number_of_commands) {
    bool const at_rest =
        stands_since > 600;  // cycles of the longest kernel, and until the filters have settled
    if (random.below(4) == 0) {
      ++commands;
      axisrt_status const status = random_command(runtime, machine, random);
      REQUIRE((status == AXISRT_OK || status == AXISRT_BUSY));
      if (status == AXISRT_OK) ++(at_rest ? accepted_at_rest : accepted_in_motion);
    }
    double const x = motion.next();
    std::array<double, axes> inputs{};
    inputs.fill(x);
    REQUIRE(runtime.step(inputs, outputs) == AXISRT_OK);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      auto const state = std::get<axisrt_axis_state>(runtime.axis_state(static_cast<std::uint32_t>(axis)));
      watch.check(axis, x, outputs[axis], state, limits);
      // The band-stop settles slowly; where no filter is, the kernel alone decides.
      bool const has_filters = !machine.axes[axis].filters.empty();
      if (at_rest && motion.stands() && !has_filters) stood = stood && outputs[axis] == x;
    }
    stands_since = motion.stands() ? stands_since + 1 : 0;
  }
  INFO("accepted in motion " << accepted_in_motion << ", at rest " << accepted_at_rest << ", most added "
                             << watch.most_added);
  CHECK(watch.excess <= 8);
  CHECK(stood);
  CHECK(accepted_in_motion > 200);
  CHECK(accepted_at_rest > 200);
  CHECK(watch.most_added > 0.02);  // fades were felt
}

}  // namespace

TEST_CASE("switching in motion keeps the bounds of velocity and acceleration, at rest nothing moves",
          "[kernel][switching]") {
  switch_often(100'000);
}

TEST_CASE("a million commands keep the bounds", "[.][long][switching]") {
  switch_often(1'000'000);
}

}  // namespace axisc::codegen::kernel_switching_test
