// Machines of every type, order, prototype, share and cycle time go all the way: design, image, verify,
// create with its self-tests, and a step from rest.
#include "codegen/image_writer.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace axisc::codegen {
namespace {

/// Commands at random; the image has banks for those with ON.
void command(image::RuntimeHost& runtime, machine::Machine const& machine, test::Random& random) {
  if (runtime.group_count() == 0) return;
  auto const& sets = machine.groups[0].filter_sets;
  machine::FilterCommand command;
  command.filter_switch = static_cast<machine::FilterSwitch>(random.below(3));
  if (!sets.empty() && random.below(2) == 0) {
    command.parameters = sets[random.below(static_cast<std::uint32_t>(sets.size()))];
  }
  axisrt_status const status = runtime.command(0, command);
  // What a command without ON builds on need not have a bank with it.
  bool const builds_on = command.filter_switch == machine::FilterSwitch::unchanged;
  bool const answered = status == AXISRT_OK || status == AXISRT_BUSY || status == AXISRT_NEEDS_STANDSTILL ||
                        (builds_on && status == AXISRT_NO_BANK);
  if (!answered) FAIL(axisrt_status_name(status));
}

bool has_dc_gain_1(image::ImageAxis const& axis) {
  return std::none_of(axis.filters.begin(), axis.filters.end(),
                      [](image::ImageFilter const& filter) { return filter.design.blocks_constant; });
}

/// Random motion with commands, then rest until every axis that can has arrived exactly.
class Run {
 public:
  Run(machine::Machine const& machine, std::vector<std::byte> const& image, test::Random& random)
      : machine_(machine),
        contents_(test::contents_of(image)),
        runtime_(test::runtime_for(image)),
        random_(random),
        outputs_(machine.axes.size()) {}

  [[nodiscard]] bool is_sound() {
    sound_ = runtime_.reset_all(x_) == AXISRT_OK;
    // Within the limits of every axis, so that no output may be called implausible, whatever is commanded.
    double fastest = 400;
    for (auto const& axis : machine_.axes) {
      double const limit = axis.velocity_limit * 10 * machine_.cycle_time.seconds();
      if (limit > 0) fastest = std::min(fastest, limit);
    }
    double velocity = 0;
    for (int n = 0; n < 1000; ++n) {
      if (n % 16 == 0) velocity = random_.below(4) == 0 ? 0 : random_.between(-fastest, fastest);
      if (random_.below(10) == 0) command(runtime_, machine_, random_);
      step(x_ + velocity);
    }
    // An output may cross the setpoint before it arrives there for good.
    int arrived = 0;
    for (int n = 0; n < longest_rest && arrived < 2000; ++n) {
      step(x_);
      arrived = has_arrived() ? arrived + 1 : 0;
    }
    return sound_ && arrived == 2000;
  }

 private:
  static constexpr int longest_rest = 200'000;

  void step(double x) {
    x_ = x;
    std::vector<double> const inputs(outputs_.size(), x);
    std::vector<double> v_add(outputs_.size());
    std::vector<double> increments(outputs_.size());
    sound_ = sound_ && runtime_.step(inputs, outputs_) == AXISRT_OK;
    sound_ = sound_ && runtime_.step_velocity({.set = inputs, .motor = inputs, .direct = {}}, v_add,
                                              increments) == AXISRT_OK;
    for (std::size_t axis = 0; axis < outputs_.size(); ++axis) {
      sound_ = sound_ && std::isfinite(outputs_[axis]) && std::isfinite(increments[axis]);
      auto const& control = contents_.axes[axis].control;
      sound_ = sound_ && std::abs(v_add[axis]) <= (control ? control->limit : 0);
    }
  }

  [[nodiscard]] bool has_arrived() const {
    for (std::size_t axis = 0; axis < outputs_.size(); ++axis) {
      if (has_dc_gain_1(contents_.axes[axis]) && outputs_[axis] != x_) return false;
    }
    return true;
  }

  machine::Machine const& machine_;
  image::ImageContents contents_;
  image::RuntimeHost runtime_;
  test::Random& random_;
  std::vector<double> outputs_;
  double x_ = 1e6;
  bool sound_ = true;
};

void check_kernel_machines(int machines) {
  test::Random random(2);
  for (int i = 0; i < machines; ++i) {
    CAPTURE(i);
    machine::Machine const machine = test::random_kernel_machine(random, 0.02);
    CHECK(Run(machine, write_image(machine, {}), random).is_sound());
  }
}

}  // namespace

TEST_CASE("random machines compile, pass their self-tests and settle", "[image][random]") {
#ifdef NDEBUG
  constexpr int machines = 2000;
#else
  constexpr int machines = 60;
#endif
  constexpr int cycles = 400;
  test::Random random(1);
  for (int i = 0; i < machines; ++i) {
    CAPTURE(i);
    machine::Machine const machine = test::random_machine(random, 0.005);
    std::vector<std::byte> const image = write_image(machine, {});
    image::ImageContents const contents = test::contents_of(image);
    image::RuntimeHost runtime = test::runtime_for(image);

    bool sound = runtime.reset_all(1000) == AXISRT_OK;
    std::vector<double> values(machine.axes.size());
    for (int n = 0; n < cycles; ++n) {
      values.assign(values.size(), n == 0 ? 1000 : 2000);
      axisrt_status const status = runtime.step(values, values);
      // A step of 1000 units is more than some axes may move in a cycle.
      sound = sound && (status == AXISRT_OK || status == AXISRT_IMPLAUSIBLE);
      for (std::size_t axis = 0; axis < values.size(); ++axis) {
        // Nothing exceeds what Σ|h| allows for the step, on top of the steady output.
        double const bound = 1000 + 1000 * contents.axes[axis].peak_gain;
        sound = sound && std::isfinite(values[axis]) && std::abs(values[axis]) <= bound * (1 + 1e-9);
      }
    }
    CHECK(sound);
  }
}

TEST_CASE("random machines with kernels and position control compile, run and settle", "[image][random]") {
#ifdef NDEBUG
  check_kernel_machines(1000);
#else
  check_kernel_machines(30);
#endif
}

TEST_CASE("ten thousand random machines with kernels and position control", "[.][slow]") {
  check_kernel_machines(10'000);
}

}  // namespace axisc::codegen
