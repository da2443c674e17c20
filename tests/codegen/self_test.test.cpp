#include "codegen/self_test.hpp"

#include "codegen/image_writer.hpp"
#include "codegen/proof.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace axisc::codegen {
namespace {

constexpr double ulp_of_largest_input = std::numeric_limits<double>::epsilon();

/// Of a filter or a kernel.
template <class Tested>
double largest_error_in_ulp(image::RuntimeHost& runtime, Tested const& tested) {
  CHECK(runtime.reset_all(0) == AXISRT_OK);
  double largest = 0;
  for (std::size_t i = 0; i < tested.self_test_input.size(); ++i) {
    std::array<double, 1> value = {tested.self_test_input[i]};
    CHECK(runtime.step(value, value) == AXISRT_OK);
    largest = std::max(largest, std::abs(value[0] - tested.self_test_output[i]));
  }
  return largest / ulp_of_largest_input;
}

}  // namespace

TEST_CASE("the runtime passes self-tests with margin", "[self-test]") {
  test::Random random(3);
#ifdef NDEBUG
  constexpr int filters = 1000;
#else
  constexpr int filters = 100;
#endif
  for (int i = 0; i < filters; ++i) {
    design::CycleTime const cycle_time{random.below(2) == 0 ? 125'000U : 2'000'000U};
    double const lowest = 0.003 / cycle_time.seconds();
    design::FilterSpecification const filter = test::random_filter(random, cycle_time, {lowest});
    CAPTURE(static_cast<int>(filter.type), static_cast<int>(filter.prototype), filter.order,
            filter.frequency.value, filter.quality, filter.time_constant.value, filter.share_percent);
    std::vector<std::byte> const image = write_image(test::machine_with({filter}, cycle_time), {});
    image::RuntimeHost runtime = test::runtime_for(image);
    // Two are allowed; how the runtime's order of operations differs from the compiler's model takes a
    // little.
    CHECK(largest_error_in_ulp(runtime, test::contents_of(image).axes[0].filters[0]) <= 1.25);
  }
}

TEST_CASE("the runtime passes self-tests of kernels with margin", "[self-test]") {
  test::Random random(6);
  for (int i = 0; i < 200; ++i) {
    machine::Machine machine = test::machine_with({}, {1'000'000});
    design::KernelSpecification kernel;
    kernel.type = static_cast<design::KernelType>(random.below(5));
    kernel.order = 1 + random.below(kernel.type == design::KernelType::time_delay ? 100 : 200);
    kernel.frequency = {random.between(10, 480)};
    kernel.quality = random.between(0.05, 1);
    kernel.share_percent = random.between(1, 100);
    machine.axes[0].kernel = test::fir(kernel, true);
    CAPTURE(static_cast<int>(kernel.type), kernel.order, kernel.frequency.value, kernel.quality);
    std::vector<std::byte> const image = write_image(machine, {});
    image::RuntimeHost runtime = test::runtime_for(image);
    CHECK(largest_error_in_ulp(runtime, test::contents_of(image).kernels.at(0)) <= 1.25);
  }
}

TEST_CASE("self-tests of kernels see every wrong tail", "[self-test]") {
  for (design::KernelType const type :
       {design::KernelType::moving_average, design::KernelType::gaussian, design::KernelType::windowed_sinc,
        design::KernelType::time_delay, design::KernelType::novib}) {
    design::KernelDesign const kernel =
        design::design_kernel({.type = type, .order = 30, .frequency = {31}}, {1'000'000});
    SelfTest const right = make_self_test(kernel);
    CHECK(right.input.size() == 32 + kernel.tail_sums.size());
    for (std::size_t tail = 0; tail < kernel.tail_sums.size(); ++tail) {
      design::KernelDesign wrong = kernel;
      wrong.tail_sums[tail] += 0x1p-40;
      SelfTest const test = make_self_test(wrong);
      double largest = 0;
      for (std::size_t n = 0; n < right.output.size(); ++n) {
        largest = std::max(largest, std::abs(test.output[n] - right.output[n]));
      }
      CAPTURE(static_cast<int>(type), tail);
      CHECK(largest > 2 * ulp_of_largest_input);
    }
  }
}

TEST_CASE("self-tests see wrong coefficients", "[self-test]") {
  design::CycleTime const cycle_time{125'000};
  test::Random random(5);
  for (int i = 0; i < 40; ++i) {
    design::FilterSpecification specification = test::random_filter(random, cycle_time, {5});
    specification.share_percent = 100;
    design::FilterDesign const filter =
        design::design_filter(specification, cycle_time, design::Precision::exact);
    if (filter.realisation != design::Realisation::sections) continue;
    SelfTest const right = make_self_test(filter);
    for (double design::IncrementSection::*coefficient :
         {&design::IncrementSection::p, &design::IncrementSection::q, &design::IncrementSection::k,
          &design::IncrementSection::b}) {
      design::FilterDesign wrong = filter;
      double& changed = wrong.sections.back().*coefficient;
      if (changed == 0) continue;
      changed *= 1 + 1e-3;
      SelfTest const test = make_self_test(wrong);
      double largest = 0;
      for (std::size_t n = 0; n < right.output.size(); ++n) {
        largest = std::max(largest, std::abs(test.output[n] - right.output[n]));
      }
      CAPTURE(static_cast<int>(specification.type), specification.order, specification.frequency.value);
      CHECK(largest > 2 * ulp_of_largest_input);
    }
  }
}

TEST_CASE("a long delay has a self-test that is longer", "[self-test]") {
  design::FilterDesign delay;
  delay.realisation = design::Realisation::delay;
  delay.delay_cycles = 100;
  SelfTest const test = make_self_test(delay);
  REQUIRE(test.input.size() == 132);
  CHECK(std::equal(test.input.begin(), test.input.begin() + 32, test.output.begin() + 100));
  CHECK(std::count(test.output.begin(), test.output.begin() + 100, 0.0) == 100);
}

TEST_CASE("a filter that passes through repeats its input", "[self-test]") {
  SelfTest const test = make_self_test(design::FilterDesign{});
  CHECK(test.input == test.output);
  CHECK(*std::max_element(test.input.begin(), test.input.end()) == 1);
}

}  // namespace axisc::codegen
