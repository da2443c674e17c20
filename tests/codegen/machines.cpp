#include "machines.hpp"

#include "design/filter_kinds.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

namespace axisc::test {
namespace {

using design::FilterSpecification;
using design::FilterType;
using design::Prototype;

std::vector<machine::ConfiguredFilter> numbered(std::vector<FilterSpecification> const& filters) {
  std::vector<machine::ConfiguredFilter> configured;
  for (FilterSpecification const& filter : filters) {
    configured.push_back({.index = static_cast<std::uint32_t>(configured.size()), .specification = filter});
  }
  return configured;
}

machine::AxisConfiguration axis(std::string name, std::uint32_t number, machine::AxisType type) {
  machine::AxisConfiguration axis;
  axis.name = std::move(name);
  axis.number = number;
  axis.type = type;
  axis.velocity_limit = 500'000;
  axis.acceleration_limit = 8000;
  return axis;
}

}  // namespace

machine::Machine sample_machine() {
  FilterSpecification const band_stop{.type = FilterType::bandstop,
                                      .prototype = Prototype::butterworth,
                                      .order = 2,
                                      .frequency = {47},
                                      .quality = 2.5};
  FilterSpecification const low_pass{.type = FilterType::lowpass,
                                     .prototype = Prototype::bessel,
                                     .order = 5,
                                     .frequency = {30},
                                     .share_percent = 60};
  FilterSpecification const high_pass{.type = FilterType::highpass,
                                      .prototype = Prototype::critical_damping,
                                      .order = 3,
                                      .frequency = {2},
                                      .share_percent = 12.5};
  FilterSpecification const lag{.type = FilterType::pt2, .order = 2, .time_constant = {12'000}};
  FilterSpecification const delay{
      .type = FilterType::time_delay, .time_constant = {3000}, .share_percent = 75};

  machine::Machine machine;
  machine.name = "sample";
  machine.cycle_time = {1'000'000};
  machine.lists = {
      {.name = "default.lis", .content = "getriebe[0].dynamik.vb_max 500000\n", .is_default_list = true},
      {.name = "axes/x.lis", .content = "filter[0].order 2\nfilter[0].guete 2.5\n"},
      {.name = "axes/ä.lis", .content = ""}};

  machine.axes = {axis("X", 1, machine::AxisType::translatory), axis("Y", 2, machine::AxisType::translatory),
                  axis("Ä", 7, machine::AxisType::rotary), axis("S", 6, machine::AxisType::spindle)};
  machine.axes[0].filters = {{.index = 0, .specification = band_stop},
                             {.index = 2, .specification = low_pass}};
  machine.axes[0].interface_filters = {{.index = 0, .specification = lag}};
  machine.axes[0].position_window = 0.25;
  machine.axes[1].filters = {{.index = 0, .specification = low_pass},
                             {.index = 1, .specification = band_stop},
                             {.index = 2, .specification = high_pass}};
  machine.axes[2].filters = {{.index = 1, .specification = delay}};
  machine.axes[0].values = {{.name = "getriebe[0].dynamik.vb_max", .text = "500000", .list = 0, .line = 1},
                            {.name = "filter[0].order", .text = "2", .list = 1, .line = 1},
                            {.name = "filter[0].guete", .text = "2.5", .list = 1, .line = 2}};
  machine.axes[1].values = {{.name = "getriebe[0].dynamik.vb_max", .text = "500000", .list = 0, .line = 1}};
  return machine;
}

machine::Machine machine_with(std::vector<FilterSpecification> const& filters, design::CycleTime cycle_time) {
  machine::Machine machine;
  machine.cycle_time = cycle_time;
  machine.axes = {axis("X", 1, machine::AxisType::translatory)};
  machine.axes[0].filters = numbered(filters);
  return machine;
}

FilterSpecification random_filter(Random& random, design::CycleTime cycle_time, design::Hertz lowest) {
  FilterSpecification filter;
  filter.type = design::filter_kinds[random.below(design::filter_kinds.size())].type;
  filter.prototype = static_cast<Prototype>(1 + random.below(3));
  filter.order = 1 + random.below(design::uses_quality(filter.type) ? 3 : 6);
  // Low frequencies are the common and the hard ones: an octave first, up to 95 % of 0.5/T. Powers of two
  // instead of the mathematical library: the same machines on every host.
  double const highest = 0.95 * cycle_time.nyquist().value;
  std::uint32_t octaves = 1;
  while (std::ldexp(lowest.value, static_cast<int>(octaves)) < highest) ++octaves;
  double const octave = std::ldexp(lowest.value, static_cast<int>(random.below(octaves)));
  filter.frequency = {std::min(octave * random.between(1, 2), highest)};
  filter.quality = random.between(1, 10);
  bool const is_delay = filter.type == FilterType::time_delay;
  double const mantissa = is_delay ? random.between(0, 5.99) : random.between(1, 2);
  double const cycles = is_delay ? mantissa : std::ldexp(mantissa, static_cast<int>(random.below(9)));
  bool const is_whole = is_delay && random.below(3) == 0;
  filter.time_constant = {(is_whole ? std::floor(cycles) : cycles) * cycle_time.microseconds()};
  filter.share_percent = random.below(2) == 0 ? 100 : random.below(101);
  return filter;
}

machine::Machine random_machine(Random& random, double lowest_frequency_times_cycle) {
  constexpr std::array cycle_times = {125'000U, 250'000U, 500'000U, 1'000'000U, 2'000'000U, 4'000'000U};
  machine::Machine machine;
  machine.cycle_time = {cycle_times[random.below(cycle_times.size())]};
  design::Hertz const lowest = {lowest_frequency_times_cycle / machine.cycle_time.seconds()};
  std::uint32_t const axes = 1 + random.below(3);
  for (std::uint32_t i = 0; i < axes; ++i) {
    machine.axes.push_back(axis("A" + std::to_string(i), i + 1, machine::AxisType::translatory));
    std::vector<FilterSpecification> filters(random.below(4));
    std::generate(filters.begin(), filters.end(),
                  [&] { return random_filter(random, machine.cycle_time, lowest); });
    machine.axes.back().filters = numbered(filters);
    if (random.below(3) == 0) {
      machine.axes.back().interface_filters = numbered({random_filter(random, machine.cycle_time, lowest)});
    }
  }
  return machine;
}

image::RuntimeHost runtime_for(std::span<std::byte const> image) {
  auto runtime = image::RuntimeHost::create(image, std::nullopt, AXISRT_LEVEL_AUTOMATIC);
  if (axisrt_status const* status = std::get_if<axisrt_status>(&runtime)) FAIL(axisrt_status_name(*status));
  return std::get<image::RuntimeHost>(std::move(runtime));
}

image::ImageContents contents_of(std::span<std::byte const> image) {
  auto contents = image::read_image(image);
  if (axisrt_status const* status = std::get_if<axisrt_status>(&contents)) FAIL(axisrt_status_name(*status));
  return std::get<image::ImageContents>(std::move(contents));
}

}  // namespace axisc::test
