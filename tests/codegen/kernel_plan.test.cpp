#include "codegen/kernel_plan.hpp"

#include "codegen/fade.hpp"
#include "codegen/image_writer.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <cmath>

namespace axisc::codegen::kernel_plan_test {
namespace {

using design::KernelSpecification;
using design::KernelType;

KernelPlan plan_of(machine::Machine const& machine, CompiledKernels& kernels, double peak_gain = 1) {
  return plan_kernels(machine, kernels, [peak_gain](std::size_t) { return peak_gain; });
}

constexpr design::CycleTime cycle_time{1'000'000};

}  // namespace

TEST_CASE("the plan of the sample: slots, members, banks", "[kernel-plan]") {
  machine::Machine const machine = test::kernel_machine();
  KnownDesigns designs;
  CompiledKernels kernels(designs, machine.cycle_time);
  KernelPlan const plan = plan_of(machine, kernels);
  REQUIRE(plan.slots.size() == 4);
  CHECK(plan.slots[0].axis == 0);
  CHECK(plan.slots[2].family == machine::KernelFamily::hsc);
  CHECK(plan.slots[2].history == kernels[plan.slots[2].kernel].design.tail_sums.size());
  CHECK(plan.slots[3].kernel == no_kernel);  // order 0
  CHECK(plan.slots[3].history == 200);       // of a bank

  REQUIRE(plan.groups.size() == 2);  // the channel without filters is left out
  PlannedGroup const& mill = plan.groups[0];
  CHECK(mill.members == std::vector<std::size_t>{0, 3, 1, 2});
  REQUIRE(mill.banks.size() == 7);
  CHECK(mill.banks[0].parameters.empty());
  CHECK(mill.banks[0].choices ==
        std::vector<std::uint32_t>{plan.slots[0].kernel, no_kernel, plan.slots[1].kernel, no_kernel});
  CHECK(mill.banks[4].choices == std::vector<std::uint32_t>(4, no_kernel));  // ORDER=0
  CHECK(mill.banks[6].hsc);
  CHECK(mill.banks[6].choices ==
        std::vector<std::uint32_t>{no_kernel, no_kernel, no_kernel, plan.slots[2].kernel});
  CHECK(mill.banks[5].choices == mill.banks[0].choices);  // FCUT changes neither Gaussian nor delay

  // Y belongs to the first channel that names it, W, without a filter, to both.
  CHECK(plan.groups[1].members == std::vector<std::size_t>{4, 3});
  CHECK(plan.slots[1].group == 0U);
  CHECK(plan.slots[3].group == 1U);
  CHECK(plan.slots[3].member == 0);
}

TEST_CASE("equal kernels are designed once", "[kernel-plan]") {
  KnownDesigns designs;
  CompiledKernels kernels(designs, cycle_time);
  KernelSpecification const average{.type = KernelType::moving_average, .order = 20};
  KernelSpecification other = average;
  other.frequency = {99};
  other.quality = 0.1;
  CHECK(kernels.index_of(average) == 0);
  CHECK(kernels.index_of(other) == 0);
  other.type = KernelType::gaussian;
  CHECK(kernels.index_of(other) == 1);
  KernelSpecification novib{.type = KernelType::novib, .order = 1, .frequency = {40}};
  CHECK(kernels.index_of(novib) == 2);
  novib.order = 77;
  CHECK(kernels.index_of(novib) == 2);
  novib.frequency = {41};
  CHECK(kernels.index_of(novib) == 3);
  novib.order = 0;
  CHECK(kernels.index_of(novib) == no_kernel);
  CHECK(kernels.index_of({.order = 20, .share_percent = 0}) == no_kernel);
  CHECK(kernels.all().size() == 4);
}

TEST_CASE("parameters change what they name", "[kernel-plan]") {
  KernelSpecification const listed{
      .type = KernelType::gaussian, .order = 7, .frequency = {30}, .quality = 0.5, .share_percent = 80};
  CHECK(machine::with_parameters(listed, {}) == listed);
  KernelSpecification const all =
      machine::with_parameters(listed, test::filter_set(9, 10, design::Hertz{12}, 1));
  CHECK(all ==
        KernelSpecification{
            .type = KernelType::gaussian, .order = 9, .frequency = {12}, .quality = 1, .share_percent = 10});
}

TEST_CASE("a fade is the longest that any axis of the channel needs", "[kernel-plan]") {
  machine::Machine machine;
  machine.cycle_time = cycle_time;
  machine.axes.resize(2);
  for (machine::AxisConfiguration& axis : machine.axes) {
    axis.velocity_limit = 100'000;
    axis.acceleration_limit = 1000;
  }
  machine.axes[0].kernel = test::fir({.type = KernelType::moving_average, .order = 20}, true);
  machine.axes[1].kernel = test::fir({.type = KernelType::time_delay, .order = 30}, true);
  machine.groups = {{.name = "c", .axes = {0, 1}, .filter_sets = {test::filter_set(2)}}};
  KnownDesigns designs;
  CompiledKernels kernels(designs, cycle_time);
  KernelPlan const plan = plan_of(machine, kernels, 1.5);
  MotionLimits const limits = motion_limits(100'000, 1000, cycle_time);
  // Sums of tails: 10 and 1 for the averages, 30 and 2 for the delays.
  CHECK(plan.groups[0].off_fade_cycles == fade_cycles(30 * 1.5, limits));
  CHECK(plan.groups[0].banks[0].fade_cycles == fade_cycles(30 * 1.5, limits));
  CHECK(plan.groups[0].banks[1].fade_cycles == fade_cycles(28 * 1.5, limits));

  machine.axes[0].acceleration_limit = 0;  // this axis only changes at standstill, and all with it
  CompiledKernels others(designs, cycle_time);
  KernelPlan const standing = plan_of(machine, others);
  for (PlannedBank const& bank : standing.groups[0].banks) CHECK(bank.fade_cycles == 0);
}

TEST_CASE("HSC banks fade as HSC filters need it, FIR banks as FIR filters do", "[kernel-plan]") {
  machine::Machine machine = test::kernel_machine();
  machine.axes[2].acceleration_limit = 0;
  KnownDesigns designs;
  CompiledKernels kernels(designs, machine.cycle_time);
  KernelPlan const plan = plan_of(machine, kernels);
  CHECK(plan.groups[0].banks[0].fade_cycles > 0);
  CHECK(plan.groups[0].banks.back().fade_cycles == 0);
  CHECK(plan.groups[0].off_fade_cycles == 0);
}

TEST_CASE("runtime and compiler mean the same order by a time", "[kernel-plan]") {
  test::Random random(4);
  for (std::uint32_t const nanoseconds : {125'000U, 333'333U, 400'000U, 1'000'000U, 4'000'000U}) {
    machine::Machine machine;
    machine.cycle_time = {nanoseconds};
    machine.axes.resize(1);
    std::vector<std::byte> const image = write_image(machine, {});
    AlignedBytes const aligned(image);
    axisrt_config config{};
    config.size = sizeof config;
    config.cycle_time_ns = nanoseconds;
    config.image = aligned.data();
    config.image_size = aligned.size();
    std::size_t alignment = 0;
    REQUIRE(axisrt_memory_size(&config, &config.memory_size, &alignment) == AXISRT_OK);
    AlignedBytes const memory(config.memory_size);
    config.memory = memory.data();
    axisrt* runtime = nullptr;
    REQUIRE(axisrt_create(&config, &runtime) == AXISRT_OK);
    for (int i = 0; i < 10'000; ++i) {
      // whole nanoseconds, often on half a cycle
      bool const half = random.below(2) == 0;
      double const cycles = random.below(250) + (half ? 0.5 : random.unit());
      double const time = std::floor(cycles * nanoseconds) / 1000;
      std::uint32_t const expected = design::order_of_time({time}, {nanoseconds}).value_or(0);
      CAPTURE(nanoseconds, time);
      REQUIRE(axisrt_order_of_time(runtime, time) == expected);
    }
  }
}

}  // namespace axisc::codegen::kernel_plan_test
