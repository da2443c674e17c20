// Which banks an image has, and how long a change takes.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

namespace bank_query_test {

using namespace axisc::test;

namespace {

axisrt_filter_command empty_command() {
  axisrt_filter_command command{};
  command.size = sizeof command;
  return command;
}

}  // namespace

TEST_CASE("a bank is the command that finds it, with the parameters that the image was written with") {
  auto const image = channel_image();
  TestRuntime runtime(write_image(image));
  REQUIRE(axisrt_bank_count(runtime.runtime, 0) == image.groups[0].banks.size());
  CHECK(axisrt_bank_count(runtime.runtime, 99) == 0);
  CHECK(axisrt_bank_count(nullptr, 0) == 0);
  runtime.reset_all(0);
  for (std::uint32_t bank = 0; bank < axisrt_bank_count(runtime.runtime, 0); ++bank) {
    auto command = empty_command();
    REQUIRE(axisrt_get_bank(runtime.runtime, 0, bank, &command) == AXISRT_OK);
    auto const& written = image.groups[0].banks[bank];
    CHECK(command.keywords == written.keywords);
    CHECK(command.order == written.order);
    CHECK(command.share == written.share);
    CHECK(axisrt_command(runtime.runtime, 0, &command) == AXISRT_OK);
  }
  auto command = empty_command();
  CHECK(axisrt_get_bank(runtime.runtime, 0, 99, &command) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_get_bank(runtime.runtime, 99, 0, &command) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_get_bank(runtime.runtime, 0, 0, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_get_bank(nullptr, 0, 0, &command) == AXISRT_BAD_ARGUMENT);
  command.size = 8;
  CHECK(axisrt_get_bank(runtime.runtime, 0, 0, &command) == AXISRT_BAD_ARGUMENT);
}

TEST_CASE("a command is busy for as many cycles as the runtime says") {
  TestRuntime runtime(write_image(channel_image()));
  runtime.reset_all(0);
  CHECK(axisrt_busy_cycles(runtime.runtime, 0) == 0);
  for (int cycle = 0; cycle < 100; ++cycle) runtime.step(1000.0 * cycle);
  REQUIRE(runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
  auto const announced = axisrt_busy_cycles(runtime.runtime, 0);
  REQUIRE(announced > 1);
  for (std::uint32_t cycle = 0; cycle < announced; ++cycle) {
    CHECK(runtime.command(AXISRT_ACTION_PROGRAM_END) == AXISRT_BUSY);
    CHECK(axisrt_busy_cycles(runtime.runtime, 0) == announced - cycle);
    runtime.step(100'000 + 1000.0 * cycle);
  }
  CHECK(axisrt_busy_cycles(runtime.runtime, 0) == 0);
  CHECK(runtime.command(AXISRT_ACTION_PROGRAM_END) == AXISRT_OK);
  CHECK(axisrt_busy_cycles(runtime.runtime, 99) == 0);
  CHECK(axisrt_busy_cycles(nullptr, 0) == 0);
}

}  // namespace bank_query_test
