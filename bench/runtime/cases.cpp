#include "bench/runtime/cases.hpp"

#include "codegen/image_writer.hpp"
#include "design/filter_design.hpp"
#include "design/kernels/kernel_design.hpp"

#include <cmath>
#include <numbers>

namespace axisc::bench {
namespace {

using design::FilterSpecification;
using design::FilterType;
using design::KernelSpecification;
using design::KernelType;

constexpr design::CycleTime cycle_time{125'000};

/// Slightly different on each axis, so that none shares its coefficients.
double own(std::size_t axis) {
  return 0.01 * static_cast<double>(axis % 256);
}

FilterSpecification band_stop(double frequency) {
  return {.type = FilterType::bandstop,
          .prototype = design::Prototype::butterworth,
          .order = 2,
          .frequency = {frequency},
          .quality = 5};
}

FilterSpecification low_pass(double frequency, std::uint32_t order) {
  return {.type = FilterType::lowpass,
          .prototype = design::Prototype::butterworth,
          .order = order,
          .frequency = {frequency}};
}

/// One axis: what its lists say.
struct Chain {
  std::vector<FilterSpecification> filters;
  std::optional<KernelSpecification> kernel;
};

Chain mixed(std::size_t axis) {
  double const f = own(axis);
  switch (axis % 8) {
    case 4: return {{band_stop(40 + f), band_stop(65 + f), band_stop(95 + f)}, {}};
    case 5:
      return {{{.type = FilterType::pt1, .time_constant = {3000 + f}}},
              KernelSpecification{.type = KernelType::moving_average, .order = 200}};
    case 6: return {{}, KernelSpecification{.type = KernelType::gaussian, .order = 200}};
    case 7: return {{low_pass(60 + f, 2)}, KernelSpecification{.type = KernelType::time_delay, .order = 20}};
    default: return {{band_stop(40 + f), low_pass(60 + f, 4)}, {}};
  }
}

Chain chain_of(std::string const& name, std::size_t axis) {
  double const f = own(axis);
  if (name == "a") return {{band_stop(40 + f), band_stop(65 + f), band_stop(95 + f)}, {}};
  if (name == "b") return {{low_pass(60 + f, 4)}, {}};
  if (name == "c") return {{}, KernelSpecification{.type = KernelType::moving_average, .order = 200}};
  if (name == "d") return {{}, KernelSpecification{.type = KernelType::gaussian, .order = 200}};
  if (name == "d_own") {
    return {{}, KernelSpecification{.type = KernelType::gaussian, .order = 200, .quality = 1 - f / 4}};
  }
  if (name == "e") {
    return {{}, KernelSpecification{.type = KernelType::windowed_sinc, .order = 200, .frequency = {60}}};
  }
  return mixed(axis);
}

/// Any stable sections: their number is what costs time.
Biquad plain_section(double frequency) {
  double const w = 2 * std::numbers::pi * frequency * cycle_time.seconds();
  double const alpha = std::sin(w) / 10;
  double const a0 = 1 + alpha;
  return {1 / a0, -2 * std::cos(w) / a0, 1 / a0, -2 * std::cos(w) / a0, (1 - alpha) / a0, 0, 0};
}

PlainAxis plain_axis(Chain const& chain) {
  PlainAxis axis;
  for (FilterSpecification const& filter : chain.filters) {
    for (auto const& section : design::design_filter(filter, cycle_time, design::Precision::quick).sections) {
      static_cast<void>(section);
      axis.sections.push_back(plain_section(filter.frequency.value));
    }
  }
  if (!chain.kernel) return axis;
  switch (chain.kernel->type) {
    case KernelType::moving_average: axis.use_average(chain.kernel->order + 1); break;
    case KernelType::time_delay: axis.use_delay(chain.kernel->order); break;
    default: axis.use_taps(design::design_kernel(*chain.kernel, cycle_time).taps); break;
  }
  return axis;
}

}  // namespace

std::vector<Case> const& cases() {
  static std::vector<Case> const all = {
      {"a", "three band-stops of order 2: six sections"},
      {"b", "low-pass of order 4: two sections"},
      {"c", "moving average of order 200"},
      {"d", "Gaussian of order 200, one kernel for all axes"},
      {"d_own", "Gaussian of order 200, each axis its own"},
      {"e", "windowed sinc of order 200, one kernel for all axes"},
      {"f", "mixed"},
  };
  return all;
}

Contender make_case(std::string const& name, std::size_t axes) {
  Contender contender;
  machine::Machine machine;
  machine.cycle_time = cycle_time;
  for (std::size_t i = 0; i < axes; ++i) {
    Chain const chain = chain_of(name, i);
    machine::AxisConfiguration axis;
    axis.name = "A" + std::to_string(i);
    axis.velocity_limit = 1e6;
    axis.acceleration_limit = 1e4;
    for (std::uint32_t k = 0; k < chain.filters.size(); ++k) {
      axis.filters.push_back({.index = k, .specification = chain.filters[k]});
    }
    if (chain.kernel) {
      axis.kernel = machine::ConfiguredKernel{.family = machine::KernelFamily::fir,
                                              .index = 0,
                                              .specification = *chain.kernel,
                                              .on_at_start = true};
    }
    machine.axes.push_back(std::move(axis));
    contender.plain.push_back(plain_axis(chain));
  }
  contender.image = codegen::write_image(machine, {.strip = true});
  return contender;
}

}  // namespace axisc::bench
