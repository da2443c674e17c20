// What an engineer expects of linear-phase filters: axes that stay in step, and a standing axis that stands.
#include "codegen/image_writer.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace axisc::codegen::kernel_behaviour_test {
namespace {

using design::KernelSpecification;
using design::KernelType;

constexpr design::CycleTime cycle_time{1'000'000};

machine::Machine machine_with_kernels(std::vector<KernelSpecification> const& kernels) {
  machine::Machine machine;
  machine.cycle_time = cycle_time;
  for (KernelSpecification const& kernel : kernels) {
    machine.axes.emplace_back();
    machine.axes.back().velocity_limit = 500'000;
    machine.axes.back().acceleration_limit = 8000;
    machine.axes.back().kernel = test::fir(kernel, true);
  }
  return machine;
}

void step(image::RuntimeHost& runtime, double x, std::vector<double>& outputs) {
  std::vector<double> const inputs(outputs.size(), x);
  if (runtime.step(inputs, outputs) != AXISRT_OK) FAIL("a step was refused");
}

bool all_equal(std::vector<double> const& values, double x) {
  return std::all_of(values.begin(), values.end(), [x](double value) { return value == x; });
}

/// Every kind of kernel of this order, as far as it exists.
std::vector<KernelSpecification> every_kind(std::uint32_t order) {
  std::vector<KernelSpecification> kernels = {
      {.type = KernelType::moving_average, .order = order},
      {.type = KernelType::gaussian, .order = order, .quality = 0.7},
      {.type = KernelType::windowed_sinc, .order = order, .frequency = {45}, .share_percent = 80}};
  if (order <= design::longest_kernel_delay) {
    kernels.push_back({.type = KernelType::time_delay, .order = order});
    kernels.push_back({.type = KernelType::time_delay, .order = order, .share_percent = 33});
  }
  if (order % 4 == 0) {
    // fs/f0 in the middle of the range that has this order
    kernels.push_back({.type = KernelType::novib, .order = 1, .frequency = {1000 / (order / 2.0)}});
  }
  return kernels;
}

/// The value itself, in every cycle, at every axis: after a reset, and at the end of a move.
bool stays_constant(image::RuntimeHost& runtime, std::size_t axes, int cycles, test::Random& random) {
  std::vector<double> outputs(axes);
  double x = std::floor(random.between(-2e9, 2e9)) / 3;
  bool constant = runtime.reset_all(x) == AXISRT_OK;
  for (int n = 0; n < cycles / 2; ++n) {
    step(runtime, x, outputs);
    constant = constant && all_equal(outputs, x);
  }
  for (int n = 0; n < 50; ++n) step(runtime, x += random.between(-3000, 3000), outputs);
  for (int n = 0; n < 200; ++n) step(runtime, x, outputs);
  for (int n = 0; n < cycles / 2; ++n) {
    step(runtime, x, outputs);
    constant = constant && all_equal(outputs, x);
  }
  return constant;
}

}  // namespace

TEST_CASE("a moving average and the time delay that belongs to it keep two axes in step", "[kernel]") {
  auto const [order, delay] = GENERATE(table<std::uint32_t, std::uint32_t>({{20, 10}, {21, 11}}));
  image::RuntimeHost runtime = test::runtime_for(
      write_image(machine_with_kernels({{.type = KernelType::moving_average, .order = order},
                                        {.type = KernelType::time_delay, .order = delay}}),
                  {}));
  std::vector<double> outputs(2);
  CHECK(runtime.reset_all(0) == AXISRT_OK);
  double largest = 0;
  for (int n = 0; n < 5000; ++n) {
    step(runtime, 8.3 * n, outputs);
    if (n < 2 * static_cast<int>(delay)) continue;  // the corner, which the moving average rounds
    largest = std::max(largest, std::abs(outputs[0] - outputs[1]));
    REQUIRE(outputs[1] == Approx(8.3 * (n - static_cast<int>(delay))).margin(1e-9));
  }
  CHECK(largest < 1e-9);
}

TEST_CASE("a constant setpoint comes out unchanged, whatever the kernel", "[kernel]") {
  test::Random random(12);
  for (std::uint32_t order = 1; order <= design::longest_kernel_order; ++order) {
    std::vector<KernelSpecification> const kernels = every_kind(order);
    image::RuntimeHost runtime =
        test::runtime_for(write_image(machine_with_kernels(kernels), {.strip = true}));
    CAPTURE(order);
    CHECK(stays_constant(runtime, kernels.size(), 500, random));
  }
}

TEST_CASE("a constant setpoint comes out unchanged for 1e5 cycles", "[kernel]") {
  test::Random random(13);
  std::vector<KernelSpecification> const kernels = every_kind(100);
  image::RuntimeHost runtime = test::runtime_for(write_image(machine_with_kernels(kernels), {}));
  CHECK(stays_constant(runtime, kernels.size(), 100'000, random));
}

TEST_CASE("a constant setpoint comes out unchanged for 1e8 cycles", "[.][slow]") {
  test::Random random(14);
  std::vector<KernelSpecification> const kernels = every_kind(20);
  image::RuntimeHost runtime = test::runtime_for(write_image(machine_with_kernels(kernels), {}));
  CHECK(stays_constant(runtime, kernels.size(), 100'000'000, random));
}

TEST_CASE("a constant setpoint comes out unchanged through any sequence of commands", "[kernel]") {
  machine::Machine machine = machine_with_kernels(every_kind(36));
  machine::MachineGroup group{.name = "channel", .axes = {}, .filter_sets = {}};
  for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) group.axes.push_back(axis);
  for (std::uint32_t const order : {0U, 1U, 12U, 77U, 100U})
    group.filter_sets.push_back(test::filter_set(order));
  group.filter_sets.push_back(test::filter_set({}, 50));
  // Without ON, orders and the share come together.
  for (std::size_t i = 0; i < 5; ++i) {
    group.filter_sets.push_back(test::filter_set(group.filter_sets[i].order, 50));
  }
  machine.groups = {group};
  image::RuntimeHost runtime = test::runtime_for(write_image(machine, {}));
  test::Random random(15);
  std::vector<double> outputs(machine.axes.size());
  double x = 1e9 / 7;
  CHECK(runtime.reset_all(x) == AXISRT_OK);
  bool constant = true;
  for (int n = 0; n < 20'000; ++n) {
    machine::FilterCommand command;
    command.filter_switch = static_cast<machine::FilterSwitch>(random.below(3));
    if (random.below(3) != 0) command.parameters = group.filter_sets[random.below(6)];
    if (random.below(20) == 0) {
      REQUIRE(runtime.end_program(0) == AXISRT_OK);
    } else {
      REQUIRE(runtime.command(0, command) == AXISRT_OK);
    }
    step(runtime, x, outputs);
    constant = constant && all_equal(outputs, x);
    if (n % 2000 != 1999) continue;
    // A move, commands in motion, and rest.
    for (int i = 0; i < 100; ++i) {
      static_cast<void>(runtime.command(0, command));
      step(runtime, x += random.between(-50, 50), outputs);
    }
    for (int i = 0; i < 4300; ++i) step(runtime, x, outputs);
  }
  CHECK(constant);
}

}  // namespace axisc::codegen::kernel_behaviour_test
