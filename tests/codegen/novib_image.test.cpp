// NoVib as a controller gets it: gains from the tail sums that stand in the image.
#include "codegen/image_writer.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace axisc::codegen::novib_image_test {
namespace {

using design::CycleTime;
using design::Hertz;

machine::Machine machine(std::vector<double> const& frequencies, CycleTime cycle_time) {
  machine::Machine machine;
  machine.cycle_time = cycle_time;
  for (double const frequency : frequencies) {
    machine.axes.emplace_back();
    machine.axes.back().kernel = machine::ConfiguredKernel{
        .family = machine::KernelFamily::hsc,
        .index = 0,
        .specification = {.type = design::KernelType::novib, .order = 1, .frequency = {frequency}},
        .on_at_start = false};
  }
  return machine;
}

/// |1 - (1 - z^-1) sum of S_j z^-j|
double gain(image::ImageKernel const& kernel, double frequency, CycleTime cycle_time) {
  using Complex = std::complex<long double>;
  long double const theta =
      2 * std::numbers::pi_v<long double> * frequency * cycle_time.nanoseconds / 1'000'000'000;
  Complex sum = 0;
  for (std::size_t j = 0; j < kernel.design.tail_sums.size(); ++j) {
    sum += std::polar(1.0L, -theta * static_cast<long double>(j)) * Complex(kernel.design.tail_sums[j]);
  }
  return static_cast<double>(std::abs(Complex(1) - (Complex(1) - std::polar(1.0L, -theta)) * sum));
}

}  // namespace

TEST_CASE("NoVib in the image suppresses its frequency and what lies within 10 % of it", "[image][novib]") {
  constexpr int frequencies = 50;
  double const limit = std::pow(10, -37.0 / 20);
  for (std::uint32_t const nanoseconds : {125'000U, 250'000U, 1'000'000U, 2'000'000U, 4'000'000U}) {
    CycleTime const cycle_time{nanoseconds};
    double const lowest = design::lowest_novib_frequency(cycle_time).value;
    double const highest = 1e9 / nanoseconds / 3.03;
    std::vector<double> list;
    for (int i = 0; i < frequencies; ++i) {
      list.push_back(lowest * std::pow(highest / lowest, double(i) / (frequencies - 1)));
    }
    image::ImageContents const contents =
        test::contents_of(write_image(machine(list, cycle_time), {.strip = true}));
    REQUIRE(contents.axes.size() == list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      REQUIRE(contents.axes[i].slot);
      image::ImageKernel const& kernel = contents.kernels[contents.axes[i].slot->kernel.value()];
      CAPTURE(nanoseconds, list[i], kernel.specification.order);
      CHECK(kernel.specification.frequency.value == list[i]);
      CHECK(gain(kernel, list[i], cycle_time) < 1e-12);
      CHECK(gain(kernel, 0.9 * list[i], cycle_time) < limit);
      CHECK(gain(kernel, 1.1 * list[i], cycle_time) < limit);
    }
  }
}

TEST_CASE("the longest NoVib kernel runs", "[image][novib]") {
  CycleTime const cycle_time{1'000'000};
  double const lowest = design::lowest_novib_frequency(cycle_time).value;
  machine::Machine slowest = machine({lowest}, cycle_time);
  slowest.axes[0].kernel->on_at_start = true;
  std::vector<std::byte> const image = write_image(slowest, {});
  image::ImageContents const contents = test::contents_of(image);
  CHECK(contents.kernels[0].design.tail_sums.size() == 200);
  CHECK(contents.kernels[0].specification.order == 200);
  CHECK(contents.axes[0].delay_cycles == 100);

  image::RuntimeHost runtime = test::runtime_for(image);
  CHECK(runtime.reset(0, 0) == AXISRT_OK);
  double largest = 0;
  for (int n = 0; n < 2000; ++n) {
    std::vector<double> value = {1000 * std::sin(2 * std::numbers::pi * lowest * 1e-3 * n)};
    CHECK(runtime.step(value, value) == AXISRT_OK);
    if (n >= 200) largest = std::max(largest, std::abs(value[0]));
  }
  CHECK(largest < 1e-9);
}

}  // namespace axisc::codegen::novib_image_test
