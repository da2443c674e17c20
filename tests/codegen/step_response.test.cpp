// From the machine through the image to the runtime: the same step response as the design's own.
#include "codegen/image_writer.hpp"
#include "design/filter_analysis.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <boost/math/constants/constants.hpp>

namespace axisc::codegen {
namespace {

std::vector<double> impulse_response(image::RuntimeHost& runtime, std::size_t cycles) {
  CHECK(runtime.reset_all(0) == AXISRT_OK);
  std::vector<double> response;
  for (std::size_t n = 0; n < cycles; ++n) {
    std::array<double, 1> value = {n == 0 ? 1.0 : 0.0};
    if (runtime.step(value, value) != AXISRT_OK) FAIL("a step was refused");
    response.push_back(value[0]);
  }
  return response;
}

/// H at `frequency` of the runtime: the sum over its impulse response.
std::complex<double> measured_response(std::vector<double> const& impulse, double frequency_times_cycle) {
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < impulse.size(); ++n) {
    double const turns = std::fmod(frequency_times_cycle * static_cast<double>(n), 1.0);
    sum += impulse[n] * std::polar(1.0, -boost::math::constants::two_pi<double>() * turns);
  }
  return sum;
}

}  // namespace

TEST_CASE("the runtime has the designed frequency response", "[image][runtime]") {
  design::CycleTime const cycle_time{1'000'000};
  test::Random random(7);
  for (int i = 0; i < 60; ++i) {
    design::FilterSpecification const filter = test::random_filter(random, cycle_time, {12});
    CAPTURE(static_cast<int>(filter.type), static_cast<int>(filter.prototype), filter.order,
            filter.frequency.value, filter.quality, filter.time_constant.value, filter.share_percent);
    design::FilterDesign const design = design::design_filter(filter, cycle_time, design::Precision::exact);
    image::RuntimeHost runtime = test::runtime_for(write_image(test::machine_with({filter}, cycle_time), {}));
    std::vector<double> const impulse = impulse_response(runtime, 16'000);
    for (double const hertz : {0.0, 1.0, 12.0, 50.0, 333.3, 500.0}) {
      std::complex<double> const expected = design::response(design, {hertz}, cycle_time);
      CHECK(std::abs(measured_response(impulse, hertz * cycle_time.seconds()) - expected) < 1e-9);
    }
  }
}

TEST_CASE("the step settles at the DC gain and overshoots as the proof says", "[image][runtime]") {
  design::CycleTime const cycle_time{500'000};
  test::Random random(11);
  for (int i = 0; i < 60; ++i) {
    design::FilterSpecification const filter = test::random_filter(random, cycle_time, {25});
    CAPTURE(static_cast<int>(filter.type), static_cast<int>(filter.prototype), filter.order,
            filter.frequency.value, filter.quality, filter.time_constant.value, filter.share_percent);
    std::vector<std::byte> const image = write_image(test::machine_with({filter}, cycle_time), {});
    image::ImageFilter const proof = test::contents_of(image).axes[0].filters[0];
    image::RuntimeHost runtime = test::runtime_for(image);
    CHECK(runtime.reset_all(0) == AXISRT_OK);

    double highest = 0;
    double path = 0;
    double previous = 0;
    for (int n = 0; n < 16'000; ++n) {
      std::array<double, 1> value = {1};
      if (runtime.step(value, value) != AXISRT_OK) FAIL("a step was refused");
      highest = std::max(highest, value[0]);
      path += std::abs(value[0] - previous);
      previous = value[0];
    }
    CHECK(previous == Approx(proof.design.dc_gain).margin(1e-12));
    CHECK(path == Approx(proof.peak_gain).epsilon(1e-9).margin(1e-9));
    if (proof.design.dc_gain > 0) {
      CHECK(proof.overshoot ==
            Approx(highest / proof.design.dc_gain - 1).margin(1e-9 / proof.design.dc_gain));
    }
  }
}

}  // namespace axisc::codegen
