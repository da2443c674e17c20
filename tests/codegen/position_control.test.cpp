// Improved Position Control from the configuration to the additive velocity: the manual's example.
#include "codegen/image_writer.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace axisc::codegen::position_control_test {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
constexpr design::CycleTime cycle_time{1'000'000};
constexpr double T = 1e-3;

machine::Machine machine(machine::PositionControl control) {
  machine::Machine machine = test::machine_with({}, cycle_time);
  machine.axes[0].position_control = std::move(control);
  return machine;
}

/// s of the bilinear transform, normalised to the pre-warped frequency f0: (2/T) (z - 1)/(z + 1) / Omega(f0).
Complex normalised_s(double f, double f0) {
  Complex const z = std::polar(1.0, 2 * pi * f * T);
  return (z - 1.0) / (z + 1.0) / std::tan(pi * f0 * T);
}

Complex oscillator(double f, double f0, double damping) {
  Complex const s = normalised_s(f, f0);
  return 1.0 / (s * s + 2 * damping * s + 1.0);
}

/// Butterworth prototype of order 1: 1/(s + 1) with s -> Q_a (s + 1/s).
Complex band_pass(double f, double f0, double quality) {
  Complex const s = normalised_s(f, f0);
  double const Q_a = std::sin(2 * pi * f0 * T) / (2 * std::tan(pi * (f0 / quality) * T));
  return 1.0 / (Q_a * (s + 1.0 / s) + 1.0);
}

struct Velocities {
  double set = 0, motor = 0, direct = 0;
};

double step(image::RuntimeHost& runtime, Velocities const& v) {
  std::array<double, 1> const set = {v.set};
  std::array<double, 1> const motor = {v.motor};
  std::array<double, 1> const direct = {v.direct};
  std::array<double, 1> v_add{};
  std::array<double, 1> increments{};
  if (runtime.step_velocity({.set = set, .motor = motor, .direct = direct}, v_add, increments) != AXISRT_OK) {
    FAIL("a step was refused");
  }
  return v_add[0];
}

/// Response of the additive velocity at f, from the response to one impulse.
Complex measured(machine::PositionControl const& control, Velocities const& impulse, double f) {
  constexpr int cycles = 8000;
  image::RuntimeHost runtime = test::runtime_for(write_image(machine(control), {}));
  CHECK(runtime.reset_velocity(0, 0, 0, 0) == AXISRT_OK);
  double const height = impulse.set + impulse.motor + impulse.direct;
  Complex sum = 0;
  for (int n = 0; n < cycles; ++n) {
    sum += step(runtime, n == 0 ? impulse : Velocities{}) * std::polar(1.0, -2 * pi * f * T * n);
  }
  return sum / height;
}

void check_equal(Complex actual, Complex expected) {
  CAPTURE(actual, expected);
  CHECK(std::abs(actual - expected) < 1e-10);
}

}  // namespace

TEST_CASE("the stages of the manual's example have the gain and phase of their formulas",
          "[position-control]") {
  machine::PositionControl const control = test::manual_position_control();
  for (double const f : {1.0, 5.0, 9.0, 11.0, 14.0, 40.0, 50.0, 53.0, 56.0, 120.0, 300.0}) {
    CAPTURE(f);
    check_equal(measured(control, {.direct = 1000}, f), -3.0 * band_pass(f, 53, 10));
    check_equal(measured(control, {.motor = 1000}, f), -1.9 * oscillator(f, 11, 0.8) * band_pass(f, 11, 2));
    check_equal(measured(control, {.set = 1000}, f), 0);
  }
}

TEST_CASE("at its frequency a direct stage counteracts, an indirect one lags by a quarter more",
          "[position-control]") {
  machine::PositionControl const control = test::manual_position_control();
  check_equal(measured(control, {.direct = 1000}, 53), -3);
  // The oscillator has the gain 1/(2 D) and lags by 90 degrees: -1.9/1.6 * -j.
  check_equal(measured(control, {.motor = 1000}, 11), Complex(0, 1.9 / 1.6));
}

TEST_CASE("the weight ends at 7", "[position-control]") {
  machine::PositionControl control = test::manual_position_control();
  control.stages[0].weight_numerator = 900;
  check_equal(measured(control, {.direct = 100}, 53), -7);
}

TEST_CASE("a stage of the set point takes the commanded velocity", "[position-control]") {
  machine::PositionControl control = test::manual_position_control();
  control.stages[1].mode = machine::StageMode::set_point;
  check_equal(measured(control, {.set = 1000}, 11), Complex(0, 1.9 / 1.6));
  check_equal(measured(control, {.motor = 1000}, 11), 0);
}

TEST_CASE("filters of the newer spelling act in series", "[position-control]") {
  machine::PositionControl control = test::manual_position_control();
  control.stages.resize(1);
  control.stages[0].filters.push_back({.type = design::FilterType::allpass,
                                       .prototype = design::Prototype::bessel,
                                       .order = 1,
                                       .frequency = {60}});
  for (double const f : {20.0, 53.0, 60.0}) {
    Complex const s = normalised_s(f, 60);
    check_equal(measured(control, {.direct = 1000}, f), -3.0 * band_pass(f, 53, 10) * (1.0 - s) / (1.0 + s));
  }
}

TEST_CASE("the additive velocity stays within its share of the axis' velocity", "[position-control]") {
  machine::PositionControl control = test::manual_position_control();
  double const factor = GENERATE(1000.0, 40.0, 0.0);
  control.limit_factor = factor;
  image::RuntimeHost runtime = test::runtime_for(write_image(machine(control), {}));
  CHECK(runtime.reset_velocity(0, 0, 0, 0) == AXISRT_OK);
  double const limit = factor / 1000 * 500'000;
  double least = 0;
  double most = 0;
  for (int n = 0; n < 1000; ++n) {
    double const v = 400'000 * std::sin(2 * pi * 53 * T * n);
    double const v_add = step(runtime, {.set = v, .motor = v, .direct = v});
    least = std::min(least, v_add);
    most = std::max(most, v_add);
  }
  CHECK(least == -limit);
  CHECK(most == limit);
}

TEST_CASE("constant velocities are not touched", "[position-control]") {
  image::RuntimeHost runtime = test::runtime_for(write_image(machine(test::manual_position_control()), {}));
  CHECK(runtime.reset_velocity(0, 1e6, 2e5, -3e5) == AXISRT_OK);
  for (int n = 0; n < 1000; ++n) {
    REQUIRE(step(runtime, {.set = 1e6, .motor = 2e5, .direct = -3e5}) == 0);
  }
}

}  // namespace axisc::codegen::position_control_test
