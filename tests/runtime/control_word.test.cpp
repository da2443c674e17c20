// The arithmetic of a cycle: subnormal numbers are taken as zero inside, and the caller's control word comes back.
#include "tests/runtime/control_word.hpp"

#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cmath>
#include <vector>

using namespace axisc::test;

namespace {

/// One call of every function that steps.
class SteppedRuntime {
 public:
  SteppedRuntime() : runtime_(write_image(channel_image())) {
    REQUIRE(runtime_.status == AXISRT_OK);
    runtime_.reset_all(0);
    for (std::uint32_t axis = 0; axis < axes; ++axis) {
      REQUIRE(axisrt_reset_velocity(runtime_.runtime, axis, 0, 0, 0) == AXISRT_OK);
    }
  }
  void step(double in) {
    for (double& setpoint : in_) setpoint = in;
    axisrt_step(runtime_.runtime, in_, out_, status_);
  }
  void step_interface(double in) {
    for (double& setpoint : in_) setpoint = in;
    axisrt_step_interface(runtime_.runtime, in_, out_, status_);
  }
  void step_velocity(double in) {
    for (double& velocity : in_) velocity = in;
    axisrt_step_velocity(runtime_.runtime, &velocities_, out_, increments_, status_);
  }

 private:
  static constexpr std::uint32_t axes = 3;
  TestRuntime runtime_;
  double in_[axes] = {};
  double out_[axes] = {};
  double increments_[axes] = {};
  std::uint8_t status_[axes] = {};
  axisrt_velocities velocities_{
      .size = sizeof(axisrt_velocities), .reserved = 0, .v_set = in_, .v_motor = in_, .v_direct = in_};
};

}  // namespace

TEST_CASE("the caller's control word comes back from every step") {
  SteppedRuntime runtime;
  for (ControlWord const word : callers_control_words()) {
    INFO(std::hex << word);
    for (double const in : {1.0, 0x1p-1060, 1e9, 0.1}) {
      ControlWord const callers = read_control_word();
      write_control_word(word);
      runtime.step(in);
      ControlWord const behind_step = read_control_word();
      write_control_word(word);
      runtime.step_interface(in);
      ControlWord const behind_interface = read_control_word();
      write_control_word(word);
      runtime.step_velocity(in);
      ControlWord const behind_velocity = read_control_word();
      write_control_word(callers);
      CHECK(without_flags(behind_step) == without_flags(word));
      CHECK(without_flags(behind_interface) == without_flags(word));
      CHECK(without_flags(behind_velocity) == without_flags(word));
    }
  }
}

#if defined(AXISC_TEST_CONTROL_WORD)

namespace {

double first_step_from_rest(std::vector<ExactFilter> const& filters, double in) {
  TestRuntime runtime(one_axis_image(filters));
  REQUIRE(runtime.status == AXISRT_OK);
  runtime.reset_all(0);
  return runtime.step(in);
}

constexpr Quad T = Quad{1} / 1000;

}  // namespace

TEST_CASE("a caller that handles subnormal numbers sees none of the cycle's exceptions") {
  SteppedRuntime runtime;
  ControlWord const callers = read_control_word();
  write_control_word(callers_control_words().front());
  std::uint32_t const before = exception_flags();
  for (double const in : {0x1p-1060, 0.1, 0x1p-1022, 1e300}) {
    runtime.step(in);
    runtime.step_interface(in);
    runtime.step_velocity(in);
  }
  std::uint32_t const after = exception_flags();
  write_control_word(callers);
  if (exceptions_are_restored) CHECK(after == before);
}

TEST_CASE("a subnormal setpoint is zero inside the step") {
  REQUIRE(0x1p-1060 > 0);
  for (double const in : {0x1p-1060, -0x1p-1060, 0x1p-1074, -0x0.fffffffffffffp-1022}) {
    CHECK(first_step_from_rest({exact::pt1(30, T)}, in) == 0);
    CHECK(first_step_from_rest({exact::bandstop(30, T, 2), exact::lowpass(60, T, 1)}, in) == 0);
    CHECK(first_step_from_rest({exact::delay(3)}, in) == 0);
  }
}

TEST_CASE("what would come out of a filter as a subnormal number comes out as zero") {
  // The first output of a delay with a share of s is (1 - s) in: a quarter of the smallest normal number.
  ExactFilter const quarter = exact::with_share(exact::delay(5), 0.75);
  double const smallest = 0x1p-1022;
  Quad const exact_output = ExactChain({quarter}, 0).step(smallest);
  REQUIRE(std::fpclassify(static_cast<double>(exact_output)) == FP_SUBNORMAL);
  CHECK(first_step_from_rest({quarter}, smallest) == 0);
  CHECK(first_step_from_rest({quarter}, 4 * smallest) == smallest);
}

TEST_CASE("a filter that dies away among the smallest numbers never puts out a subnormal one") {
  TestRuntime runtime(one_axis_image({exact::highpass(30, T, 1), exact::pt2(20, T)}));
  REQUIRE(runtime.status == AXISRT_OK);
  runtime.reset_all(0);
  unsigned subnormal = 0;
  for (int cycle = 0; cycle < 20'000; ++cycle) {
    double const out = runtime.step(cycle < 3 ? std::ldexp(1.7, -1019 - cycle) : 0);
    subnormal += std::fpclassify(out) == FP_SUBNORMAL ? 1 : 0;
  }
  CHECK(subnormal == 0);
}

#endif
