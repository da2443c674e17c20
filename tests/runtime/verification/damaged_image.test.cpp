// Damaged images: every answer is a status, and whatever is accepted can be executed.
#include "axisrt.h"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace damaged_image_test {

using namespace axisc::test;

namespace {

axisrt_status verify(Bytes const& bytes) {
  AlignedMemory const image(bytes);
  return axisrt_verify(image.data(), image.size());
}

void command(TestRuntime& runtime, std::uint32_t group, axisrt_action action) {
  axisrt_filter_command command{};
  command.size = sizeof command;
  command.action = static_cast<std::uint32_t>(action);
  command.keywords = group % 2 == 0 ? 0 : AXISRT_KEYWORD_HSC;
  static_cast<void>(axisrt_command(runtime.runtime, group, &command));
}

void step_velocity(TestRuntime& runtime, double in) {
  std::uint32_t const axes = axisrt_axis_count(runtime.runtime);
  for (std::uint32_t axis = 0; axis < axes; ++axis) {
    REQUIRE(axisrt_reset_velocity(runtime.runtime, axis, 0, 0, 0) == AXISRT_OK);
  }
  std::vector<double> const velocity(axes, in);
  std::vector<double> v_add(axes);
  std::vector<double> increments(axes);
  axisrt_velocities velocities{};
  velocities.size = sizeof velocities;
  velocities.v_set = velocities.v_motor = velocity.data();
  REQUIRE(axisrt_step_velocity(runtime.runtime, &velocities, v_add.data(), increments.data(), nullptr) ==
          AXISRT_OK);
  for (double const v : increments) REQUIRE(std::isfinite(v));
}

/// Creates and runs; whether the self-tests pass does not matter here.
void execute(Bytes const& bytes) {
  TestRuntime runtime(bytes, static_cast<std::uint32_t>(peek(bytes, 32, 4)));
  if (runtime.runtime == nullptr) {
    REQUIRE(runtime.status == AXISRT_SELF_TEST_FAILED);
    return;
  }
  std::uint32_t const axes = axisrt_axis_count(runtime.runtime);
  for (std::uint32_t axis = 0; axis < axes; ++axis) {
    REQUIRE(axisrt_reset(runtime.runtime, axis, 1e9) == AXISRT_OK);
    REQUIRE(axisrt_reset_interface(runtime.runtime, axis, -1e9) == AXISRT_OK);
  }
  for (double const in : {1e9, -0x1p53, 0x1p53, 0.0, 1e-300}) {
    REQUIRE(std::isfinite(runtime.step(in)));
    REQUIRE(std::isfinite(runtime.step_interface(in)));
    for (std::uint32_t group = 0; group < axisrt_group_count(runtime.runtime); ++group) {
      command(runtime, group, in > 1 ? AXISRT_ACTION_OFF : AXISRT_ACTION_ON);
    }
    step_velocity(runtime, in);
  }
}

}  // namespace

TEST_CASE("an image that was cut at any length is refused") {
  Bytes const whole = write_image(GENERATE(complete_image(), channel_image()));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    REQUIRE(verify(cut) == AXISRT_TOO_SHORT);
    if (size < 128) continue;
    // the same with a header that knows of the cut
    poke(cut, 16, size, 8);
    repair_checksums(cut);
    axisrt_status const status = verify(cut);
    bool const only_padding_cut = status == AXISRT_OK;
    REQUIRE((only_padding_cut ? size + 64 > whole.size() : status == AXISRT_OUT_OF_BOUNDS));
  }
}

TEST_CASE("an image with a byte too many is refused") {
  Bytes longer = write_image(complete_image());
  longer.push_back(0);
  CHECK(verify(longer) == AXISRT_WRONG_SIZE);
}

TEST_CASE("every bit flip is refused") {
  Bytes bytes = write_image(GENERATE(complete_image(), channel_image()));
  AlignedMemory image(bytes);
  for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
    auto const mask = static_cast<std::uint8_t>(1U << bit % 8);
    image.data()[bit / 8] ^= mask;
    REQUIRE(axisrt_verify(image.data(), image.size()) != AXISRT_OK);
    image.data()[bit / 8] ^= mask;
  }
}

TEST_CASE("every bit flip with right checksums is refused or harmless") {
  bool const with_kernels = GENERATE(false, true);
  ImageRecord small = with_kernels ? channel_image() : complete_image();
  if (!with_kernels) small.axes.resize(1);
  Bytes const whole = write_image(small);
  std::size_t accepted = 0;
  // Sanitizers look at the header and every fifth bit after it.
  for (std::size_t bit = 0; bit < whole.size() * 8; bit += sanitized && bit >= 4096 ? 5 : 1) {
    Bytes bytes = whole;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    repair_checksums(bytes);
    if (verify(bytes) != AXISRT_OK) continue;
    ++accepted;
    if (bit % 7 == 0 || bit < 4096) execute(bytes);
  }
  CHECK(accepted > 0);
}

}  // namespace damaged_image_test
