#include "machines.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace axisc::test {
namespace {

using design::FilterSpecification;
using design::FilterType;
using design::KernelSpecification;
using design::KernelType;
using design::Prototype;
using machine::KernelFamily;
using machine::StageMode;

FilterSpecification band_pass(double frequency, double quality) {
  return {.type = FilterType::bandpass,
          .prototype = Prototype::butterworth,
          .order = 1,
          .frequency = {frequency},
          .quality = quality};
}

machine::AxisConfiguration axis(std::string name, std::uint32_t number) {
  machine::AxisConfiguration axis;
  axis.name = std::move(name);
  axis.number = number;
  axis.velocity_limit = 500'000;
  axis.acceleration_limit = 8000;
  return axis;
}

KernelType random_fir_type(Random& random) {
  return static_cast<KernelType>(random.below(4));
}

machine::ConfiguredKernel random_kernel(Random& random, design::CycleTime cycle_time) {
  bool const hsc = random.below(3) == 0;
  machine::ConfiguredKernel kernel;
  kernel.family = hsc ? KernelFamily::hsc : KernelFamily::fir;
  KernelSpecification& specification = kernel.specification;
  specification.type = random_fir_type(random);
  if (hsc) specification.type = random.below(2) == 0 ? KernelType::novib : KernelType::moving_average;
  bool const is_delay = specification.type == KernelType::time_delay;
  specification.order = random.below((is_delay ? design::longest_kernel_delay : 200) + 1);
  double const nyquist = cycle_time.nyquist().value;
  double const lowest = 1.001 * design::lowest_novib_frequency(cycle_time).value;
  specification.frequency = {random.between(lowest, 0.95 * nyquist)};
  specification.quality = random.between(0.05, 1);
  specification.share_percent = random.below(2) == 0 ? 100 : random.below(101);
  kernel.on_at_start = !hsc && random.below(3) != 0;
  return kernel;
}

machine::FilterParameters random_parameters(Random& random, design::CycleTime cycle_time) {
  machine::FilterParameters parameters;
  if (random.below(2) == 0) parameters.order = random.below(101);
  if (random.below(2) == 0) parameters.share_percent = random.below(101);
  if (random.below(4) == 0) parameters.frequency = {random.between(0.01, 0.9) * cycle_time.nyquist().value};
  if (parameters.empty() || random.below(4) == 0) parameters.quality = random.between(0.1, 1);
  return parameters;
}

machine::PositionControl random_position_control(Random& random, design::CycleTime cycle_time) {
  double const nyquist = cycle_time.nyquist().value;
  machine::PositionControl control;
  control.limit_factor = random.below(1001);
  std::uint32_t const stages = 1 + random.below(3);
  for (std::uint32_t i = 0; i < stages; ++i) {
    machine::PositionControlStage stage;
    stage.index = i;
    stage.mode = static_cast<StageMode>(1 + random.below(3));
    double const frequency = random.between(0.005, 0.5) * nyquist;
    if (stage.mode != StageMode::direct) {
      stage.oscillator = {.frequency = {frequency}, .damping = random.between(0.05, 2)};
    }
    stage.filters = {band_pass(frequency, random.between(1, 10))};
    stage.filters[0].order = 1 + random.below(3);
    if (random.below(3) == 0) {
      stage.filters.push_back({.type = FilterType::allpass,
                               .prototype = Prototype::bessel,
                               .order = 1 + random.below(6),
                               .frequency = {frequency}});
    }
    stage.weight_numerator = random.below(1000);
    stage.weight_denominator = 1 + random.below(200);
    control.stages.push_back(std::move(stage));
  }
  return control;
}

machine::DriveScaling random_scaling(Random& random) {
  return {.controller = static_cast<machine::PositionController>(random.below(3)),
          .v_reso_num = 1.0 + random.below(10'000),
          .v_reso_denom = 1.0 + random.below(1000),
          .time_base = random.below(3),
          .multi_gain_z = 1.0 + random.below(1000),
          .multi_gain_n = 1.0 + random.below(100)};
}

}  // namespace

machine::PositionControl manual_position_control() {
  return {.stages = {{.index = 0,
                      .mode = StageMode::direct,
                      .oscillator = std::nullopt,
                      .filters = {band_pass(53, 10)},
                      .weight_numerator = 300,
                      .weight_denominator = 100},
                     {.index = 1,
                      .mode = StageMode::indirect,
                      .oscillator = {{.frequency = {11}, .damping = 0.8}},
                      .filters = {band_pass(11, 2)},
                      .weight_numerator = 190,
                      .weight_denominator = 100}},
          .limit_factor = 1000};
}

machine::ConfiguredKernel fir(design::KernelSpecification const& specification, bool on_at_start) {
  return {
      .family = KernelFamily::fir, .index = 0, .specification = specification, .on_at_start = on_at_start};
}

machine::Machine kernel_machine() {
  machine::Machine machine;
  machine.cycle_time = {1'000'000};
  machine.lists = {{.name = "x.lis", .content = "filter_fir.order 21\n"}};
  machine.axes = {axis("X", 1), axis("Y", 2), axis("Z", 3), axis("W", 4), axis("C", 5)};
  machine.axes[0].filters = {
      {.index = 1, .specification = {.type = FilterType::pt1, .time_constant = {5000}}}};
  machine.axes[0].kernel = fir({.type = KernelType::gaussian, .order = 21, .quality = 0.75}, true);
  machine.axes[0].position_control = manual_position_control();
  machine.axes[0].drive_scaling = {
      .controller = machine::PositionController::drive, .v_reso_num = 3, .v_reso_denom = 7, .time_base = 2};
  machine.axes[0].values = {{.name = "filter_fir.order", .text = "21", .list = 0, .line = 1}};
  machine.axes[1].kernel = fir({.type = KernelType::time_delay, .order = 11}, true);
  machine.axes[2].filters = {{.index = 1, .specification = band_pass(20, 1)}};
  machine.axes[2].kernel = machine::ConfiguredKernel{
      .family = KernelFamily::hsc,
      .index = 0,
      .specification = {.type = KernelType::novib, .order = 5, .frequency = {40}, .share_percent = 90},
      .on_at_start = false};
  machine.axes[3].gantry_master = 0;
  machine.axes[3].drive_scaling = {
      .controller = machine::PositionController::cnc, .multi_gain_z = 8, .multi_gain_n = 3};
  machine.axes[4].type = machine::AxisType::rotary;
  machine.axes[4].kernel = fir({.type = KernelType::moving_average, .order = 0}, false);
  machine.groups = {{.name = "mill",
                     .axes = {0, 3, 1, 2},
                     .filter_sets = {filter_set(40), filter_set(21, 50), filter_set({}, {}, {}, 0.5),
                                     filter_set(0), filter_set({}, {}, design::Hertz{25})}},
                    {.name = "empty", .axes = {3}, .filter_sets = {filter_set(7)}},
                    {.name = "turn", .axes = {4, 1, 3}, .filter_sets = {filter_set(200)}}};
  return machine;
}

machine::Machine random_kernel_machine(Random& random, double lowest_frequency_times_cycle) {
  machine::Machine machine = random_machine(random, lowest_frequency_times_cycle);
  auto const axes = static_cast<std::uint32_t>(machine.axes.size());
  for (machine::AxisConfiguration& axis : machine.axes) {
    if (random.below(4) != 0) axis.kernel = random_kernel(random, machine.cycle_time);
    bool const takes_first_filter =
        axis.kernel && axis.kernel->family == KernelFamily::hsc && !axis.filters.empty();
    if (takes_first_filter) axis.filters.erase(axis.filters.begin());
    axis.velocity_limit = 1000.0 * (1 + random.below(2000));
    axis.acceleration_limit = 100.0 * (1 + random.below(200));
    if (random.below(3) == 0) axis.position_control = random_position_control(random, machine.cycle_time);
    axis.drive_scaling = random_scaling(random);
  }
  for (std::uint32_t i = 1; i < axes; ++i) {
    if (random.below(3) != 0 || !machine.axes[0].position_control) continue;
    machine.axes[i].position_control.reset();
    machine.axes[i].gantry_master = 0;
  }
  machine::MachineGroup group{.name = "channel", .axes = {}, .filter_sets = {}};
  for (std::uint32_t i = 0; i < axes; ++i) {
    if (random.below(5) != 0) group.axes.push_back(i);
  }
  std::uint32_t const sets = random.below(4);
  while (group.filter_sets.size() < sets) {
    auto const set = random_parameters(random, machine.cycle_time);
    if (std::find(group.filter_sets.begin(), group.filter_sets.end(), set) == group.filter_sets.end()) {
      group.filter_sets.push_back(set);
    }
  }
  machine.groups = {std::move(group)};
  return machine;
}

}  // namespace axisc::test
