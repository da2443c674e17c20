// Improved Position Control: which velocity goes in, what comes out, limits, resets, gantry slaves.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace position_control_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;

/// A stage whose filter passes its velocity on.
StageRecord plain_stage(std::uint32_t mode, double weight) {
  FilterRecord pass;
  pass.realisation = 0;
  return {.index = 0, .mode = mode, .weight = weight, .filters = {pass}};
}

ImageRecord one_control(std::vector<StageRecord> const& stages, double limit = 1e9, double scale = 1) {
  ImageRecord image;
  image.axes.resize(2);
  image.controls = {{.axis = 1, .source = 1, .stages = stages, .limit = limit, .scale = scale}};
  return image;
}

struct Cycle {
  std::vector<double> v_set, v_motor, v_direct;
};

struct Result {
  axisrt_status status = AXISRT_OK;
  std::vector<double> v_add, increments;
  std::vector<std::uint8_t> statuses;
};

Result step(TestRuntime& runtime, Cycle const& in) {
  std::size_t const axes = in.v_set.size();
  Result result{.v_add = std::vector<double>(axes, 99),
                .increments = std::vector<double>(axes, 99),
                .statuses = std::vector<std::uint8_t>(axes, 99)};
  axisrt_velocities const velocities{.size = sizeof velocities,
                                     .reserved = 0,
                                     .v_set = in.v_set.data(),
                                     .v_motor = in.v_motor.data(),
                                     .v_direct = in.v_direct.empty() ? nullptr : in.v_direct.data()};
  result.status = axisrt_step_velocity(runtime.runtime, &velocities, result.v_add.data(),
                                       result.increments.data(), result.statuses.data());
  return result;
}

}  // namespace

TEST_CASE("each mode takes its velocity, the stages' sum is subtracted") {
  Cycle const in{.v_set = {0, 1000}, .v_motor = {0, 200}, .v_direct = {0, 30}};
  Cycle const without_direct{.v_set = {0, 1000}, .v_motor = {0, 200}, .v_direct = {}};
  struct Case {
    std::vector<StageRecord> stages;
    double expected, expected_without_direct;
  };
  std::vector<Case> const cases = {
      {{plain_stage(1, 1)}, -30, -200},
      {{plain_stage(2, 1)}, -200, -200},
      {{plain_stage(3, 1)}, -1000, -1000},
      {{plain_stage(1, 2), plain_stage(2, 0.5), plain_stage(3, 7)}, -60 - 100 - 7000, -400 - 100 - 7000},
      {{plain_stage(3, 0)}, 0, 0},
  };
  for (Case const& one : cases) {
    TestRuntime runtime(write_image(one_control(one.stages)));
    REQUIRE(axisrt_reset_velocity(runtime.runtime, 1, 0, 0, 0) == AXISRT_OK);
    Result const result = step(runtime, in);
    CHECK(result.status == AXISRT_OK);
    CHECK(result.v_add == std::vector<double>{0, one.expected});
    CHECK(result.increments == std::vector<double>{0, one.expected});
    CHECK(step(runtime, without_direct).v_add[1] == one.expected_without_direct);
  }
}

TEST_CASE("a stage is the series of its filters") {
  TestRuntime runtime(write_image(channel_image()));
  ExactChain direct({exact::bandpass(53, T, 2)}, 0);
  ExactChain indirect({exact::lowpass(11, T, Quad{1} / (2 * (Quad{4} / 5))), exact::bandpass(11, T, 2)}, 0);
  REQUIRE(axisrt_reset_velocity(runtime.runtime, 0, 0, 0, 0) == AXISRT_OK);
  for (int cycle = 0; cycle < 2000; ++cycle) {
    double const motor = 700 * std::sin(cycle * 0.07);
    double const measured = 500 * std::sin(cycle * 0.33);
    Result const result =
        step(runtime,
             {.v_set = std::vector<double>(3, 1e9), .v_motor = {motor, 0, 0}, .v_direct = {measured, 0, 0}});
    Quad const expected = -(3 * direct.step(measured) + static_cast<Quad>(1.9) * indirect.step(motor));
    REQUIRE(static_cast<double>(absolute(static_cast<Quad>(result.v_add[0]) - expected)) < 1e-8);
  }
}

TEST_CASE("the additive velocity is limited to the last bit, in both directions") {
  constexpr double limit = 1234.5;
  double const below = std::nextafter(limit, 0.0);
  double const above = std::nextafter(limit, 2e3);
  TestRuntime runtime(write_image(one_control({plain_stage(3, 1)}, limit, 2)));
  REQUIRE(axisrt_reset_velocity(runtime.runtime, 1, 0, 0, 0) == AXISRT_OK);
  struct Case {
    double in, out;
  };
  for (Case const one : {Case{below, -below}, Case{limit, -limit}, Case{above, -limit}, Case{0x1p53, -limit},
                         Case{-below, below}, Case{-limit, limit}, Case{-above, limit}, Case{0, 0}}) {
    Result const result = step(runtime, {.v_set = {0, one.in}, .v_motor = {0, 0}, .v_direct = {}});
    CHECK(result.status == AXISRT_OK);
    CHECK(result.v_add[1] == one.out);
    CHECK(result.increments[1] == 2 * one.out);
  }
}

TEST_CASE("a limit of 0, whatever its sign, lets nothing through") {
  for (double const limit : {0.0, -0.0}) {
    TestRuntime runtime(write_image(one_control({plain_stage(3, 1)}, limit)));
    REQUIRE(runtime.status == AXISRT_OK);
    REQUIRE(axisrt_reset_velocity(runtime.runtime, 1, 0, 0, 0) == AXISRT_OK);
    CHECK(step(runtime, {.v_set = {0, 500}, .v_motor = {0, 0}, .v_direct = {}}).v_add[1] == 0);
  }
}

TEST_CASE("without a reset the additive velocity stays 0") {
  TestRuntime runtime(write_image(one_control({plain_stage(3, 1)})));
  Cycle const in{.v_set = {5, 500}, .v_motor = {0, 0}, .v_direct = {}};
  Result const before = step(runtime, in);
  CHECK(before.status == AXISRT_NOT_RESET);
  CHECK(before.v_add == std::vector<double>{0, 0});
  CHECK(before.statuses == std::vector<std::uint8_t>{AXISRT_OK, AXISRT_NOT_RESET});
  REQUIRE(axisrt_reset_velocity(runtime.runtime, 1, 0, 0, 0) == AXISRT_OK);
  CHECK(step(runtime, in).v_add[1] == -500);
}

TEST_CASE("a reset begins in the steady state for these velocities") {
  TestRuntime runtime(write_image(channel_image()));
  REQUIRE(axisrt_reset_velocity(runtime.runtime, 0, 100, -2000, 3000) == AXISRT_OK);
  Cycle const in{.v_set = {100, 0, 0}, .v_motor = {-2000, 0, 0}, .v_direct = {3000, 0, 0}};
  for (int cycle = 0; cycle < 100; ++cycle) REQUIRE(step(runtime, in).v_add[0] == 0);

  TestRuntime plain(write_image(one_control({plain_stage(2, 1)})));
  REQUIRE(axisrt_reset_velocity(plain.runtime, 1, 1, 2, 3) == AXISRT_OK);
  constexpr double bad = std::numeric_limits<double>::quiet_NaN();
  CHECK(step(plain, {.v_set = {0, 0}, .v_motor = {0, bad}, .v_direct = {}}).v_add[1] == -2);
}

TEST_CASE("a velocity that is not good is the last good one") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  TestRuntime runtime(write_image(one_control({plain_stage(2, 1), plain_stage(3, 1)})));
  REQUIRE(axisrt_reset_velocity(runtime.runtime, 1, 0, 0, 0) == AXISRT_OK);
  CHECK(step(runtime, {.v_set = {0, 5}, .v_motor = {0, 70}, .v_direct = {}}).v_add[1] == -75);
  Result const result = step(runtime, {.v_set = {0, 6}, .v_motor = {0, infinity}, .v_direct = {}});
  CHECK(result.status == AXISRT_BAD_INPUT);
  CHECK(result.v_add[1] == -76);
  CHECK(result.statuses == std::vector<std::uint8_t>{AXISRT_OK, AXISRT_BAD_INPUT});
  // a velocity that no stage looks at may be anything
  CHECK(step(runtime, {.v_set = {infinity, 6}, .v_motor = {NAN, 70}, .v_direct = {NAN, NAN}}).status ==
        AXISRT_OK);
}

TEST_CASE("a gantry slave gets its master's additive velocity with its own scale") {
  TestRuntime runtime(write_image(channel_image()));
  CHECK(axisrt_has_position_control(runtime.runtime, 0) == 1);
  CHECK(axisrt_has_position_control(runtime.runtime, 1) == 0);
  CHECK(axisrt_has_position_control(runtime.runtime, 2) == 1);
  CHECK(axisrt_has_position_control(runtime.runtime, 3) == 0);
  CHECK(axisrt_has_position_control(nullptr, 0) == 0);
  CHECK(axisrt_reset_velocity(runtime.runtime, 2, 9, 9, 9) == AXISRT_OK);  // has nothing to reset
  CHECK(step(runtime, {.v_set = {0, 0, 0}, .v_motor = {0, 0, 0}, .v_direct = {}}).status == AXISRT_NOT_RESET);
  REQUIRE(axisrt_reset_velocity(runtime.runtime, 0, 0, 0, 0) == AXISRT_OK);
  bool limited = false;
  for (int cycle = 0; cycle < 500; ++cycle) {
    double const v = 9000 * std::sin(cycle * 0.333);
    Result const result = step(runtime, {.v_set = {0, v, v}, .v_motor = {v, v, 77}, .v_direct = {}});
    REQUIRE(result.v_add[2] == result.v_add[0]);
    REQUIRE(result.v_add[1] == 0);
    REQUIRE(result.increments[0] == 0.25 * result.v_add[0]);
    REQUIRE(result.increments[1] == 0);
    REQUIRE(result.increments[2] == 3 * result.v_add[0]);
    REQUIRE(result.statuses == std::vector<std::uint8_t>(3, AXISRT_OK));
    limited = limited || std::fabs(result.v_add[0]) == 5000;
  }
  CHECK(limited);
}

TEST_CASE("a master may stand behind its slave") {
  ImageRecord image = one_control({plain_stage(3, 1)}, 100, 2);
  image.controls.insert(image.controls.begin(), {.axis = 0, .source = 1, .stages = {}, .scale = -1});
  TestRuntime runtime(write_image(image));
  REQUIRE(axisrt_reset_velocity(runtime.runtime, 1, 0, 0, 0) == AXISRT_OK);
  Result const result = step(runtime, {.v_set = {7, 42}, .v_motor = {0, 0}, .v_direct = {}});
  CHECK(result.v_add == std::vector<double>{-42, -42});
  CHECK(result.increments == std::vector<double>{42, -84});
}

TEST_CASE("bad arguments of the velocity side are refused") {
  TestRuntime runtime(write_image(channel_image()));
  double const v[3] = {};
  double v_add[3] = {};
  axisrt_velocities in{.size = sizeof in, .reserved = 0, .v_set = v, .v_motor = v, .v_direct = nullptr};
  CHECK(axisrt_step_velocity(nullptr, &in, v_add, nullptr, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_step_velocity(runtime.runtime, nullptr, v_add, nullptr, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_step_velocity(runtime.runtime, &in, nullptr, nullptr, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_step_velocity(runtime.runtime, &in, v_add, nullptr, nullptr) == AXISRT_NOT_RESET);
  in.size = 8;
  CHECK(axisrt_step_velocity(runtime.runtime, &in, v_add, nullptr, nullptr) == AXISRT_BAD_ARGUMENT);
  in = {.size = sizeof in, .reserved = 1, .v_set = v, .v_motor = v, .v_direct = nullptr};
  CHECK(axisrt_step_velocity(runtime.runtime, &in, v_add, nullptr, nullptr) == AXISRT_BAD_ARGUMENT);
  in = {.size = sizeof in, .reserved = 0, .v_set = nullptr, .v_motor = v, .v_direct = v};
  CHECK(axisrt_step_velocity(runtime.runtime, &in, v_add, nullptr, nullptr) == AXISRT_BAD_ARGUMENT);
  in = {.size = sizeof in, .reserved = 0, .v_set = v, .v_motor = nullptr, .v_direct = v};
  CHECK(axisrt_step_velocity(runtime.runtime, &in, v_add, nullptr, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_reset_velocity(nullptr, 0, 0, 0, 0) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_reset_velocity(runtime.runtime, 3, 0, 0, 0) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_reset_velocity(runtime.runtime, 0, NAN, 0, 0) == AXISRT_BAD_INPUT);
  CHECK(axisrt_reset_velocity(runtime.runtime, 0, 0, 0x1p54, 0) == AXISRT_BAD_INPUT);
  CHECK(axisrt_reset_velocity(runtime.runtime, 0, 0, 0, -HUGE_VAL) == AXISRT_BAD_INPUT);
}

}  // namespace position_control_test
