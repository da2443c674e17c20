// #FILTER commands: which kernel each action gives each axis, and when a command is refused.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cmath>
#include <vector>

namespace kernel_command_test {

using namespace axisc::test;

namespace {

/// The first axis moves, the others stand at 0.
void move(TestRuntime& runtime, int cycles, double& position) {
  for (int i = 0; i < cycles; ++i) static_cast<void>(runtime.step_all({position += 10, 0, 0}));
}

void rest(TestRuntime& runtime, int cycles, double position) {
  for (int i = 0; i < cycles; ++i) static_cast<void>(runtime.step_all({position, 0, 0}));
}

constexpr int until_rest = 3000;  // the PT1 before the kernel has settled then

}  // namespace

TEST_CASE("an image says what works from start-up") {
  TestRuntime const runtime(write_image(channel_image()));
  REQUIRE(runtime.status == AXISRT_OK);
  CHECK(runtime.state(0).kernel == 0);
  CHECK(runtime.state(1).kernel == AXISRT_NO_KERNEL);
  CHECK(runtime.state(2).kernel == AXISRT_NO_KERNEL);
}

TEST_CASE("at rest a command changes the kernel at once, and no output moves") {
  TestRuntime runtime(write_image(channel_image()));
  runtime.reset_all(1e9);
  struct Step {
    axisrt_action action;
    std::uint32_t keywords, order;
    double share;
    std::uint32_t kernel_x, kernel_y;
  };
  std::vector<Step> const steps = {
      {AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 8, 0, 1, none},
      {AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER | AXISRT_KEYWORD_SHARE, 3, 50, 3, none},
      {AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 8, 0, 1, none},
      {AXISRT_ACTION_ON, AXISRT_KEYWORD_HSC, 0, 0, 1, 2},
      {AXISRT_ACTION_ON, 0, 0, 0, 0, 2},
      {AXISRT_ACTION_ON, AXISRT_KEYWORD_QUALITY, 0, 0, 2, 2},
      {AXISRT_ACTION_ON, 0, 0, 0, 0, 2},
      {AXISRT_ACTION_OFF, 0, 0, 0, none, none},
      {AXISRT_ACTION_SET, AXISRT_KEYWORD_ORDER, 8, 0, none, none},
      {AXISRT_ACTION_SET, AXISRT_KEYWORD_HSC, 0, 0, none, none},
      {AXISRT_ACTION_ON, AXISRT_KEYWORD_HSC, 0, 0, none, 2},
      {AXISRT_ACTION_PROGRAM_END, 0, 0, 0, 0, none},
      {AXISRT_ACTION_OFF, AXISRT_KEYWORD_ORDER, 77, 0, none, none},
      {AXISRT_ACTION_PROGRAM_END, AXISRT_KEYWORD_ORDER, 77, 0, 0, none},
  };
  for (Step const& step : steps) {
    REQUIRE(runtime.command(step.action, step.keywords, step.order, step.share) == AXISRT_OK);
    CHECK(runtime.state(0).kernel == step.kernel_x);
    CHECK(runtime.state(1).kernel == step.kernel_y);
    CHECK(runtime.state(0).fading == 0);
    for (double const y : runtime.step_all({1e9, 1e9, 1e9})) CHECK(y == 1e9);
  }
}

TEST_CASE("without ON a command keeps what earlier ones said, ON forgets it") {
  ImageRecord image = channel_image();
  auto& banks = image.groups[0].banks;
  banks.push_back({.keywords = 9, .order = 8, .quality = 0.5, .choices = {3, none, none}});
  banks.push_back({.keywords = 11, .order = 8, .share = 50, .quality = 0.5, .choices = {2, none, none}});
  TestRuntime runtime(write_image(image));
  runtime.reset_all(0);
  auto const gives = [&](axisrt_action action, std::uint32_t keywords, std::uint32_t order, double share,
                         std::uint32_t kernel) {
    REQUIRE(runtime.command(action, keywords, order, share) == AXISRT_OK);
    CHECK(runtime.state(0).kernel == kernel);
  };
  constexpr std::uint32_t order = AXISRT_KEYWORD_ORDER;
  constexpr std::uint32_t share = AXISRT_KEYWORD_SHARE;
  constexpr std::uint32_t quality = AXISRT_KEYWORD_QUALITY;
  gives(AXISRT_ACTION_ON, order, 8, 0, 1);
  gives(AXISRT_ACTION_SET, 0, 0, 0, 1);
  gives(AXISRT_ACTION_SET, quality, 0, 0, 3);
  gives(AXISRT_ACTION_ON, AXISRT_KEYWORD_HSC, 0, 0, 3);
  gives(AXISRT_ACTION_SET, AXISRT_KEYWORD_HSC, 0, 0, 3);
  gives(AXISRT_ACTION_SET, share, 0, 50, 2);
  // ORDER=3 with the share and the quality of before is no bank, and nothing changes.
  CHECK(runtime.command(AXISRT_ACTION_SET, order, 3) == AXISRT_NO_BANK);
  gives(AXISRT_ACTION_SET, order, 8, 0, 2);
  gives(AXISRT_ACTION_OFF, order, 77, 0, none);
  gives(AXISRT_ACTION_SET, share | order, 8, 50, none);
  gives(AXISRT_ACTION_ON, order | share, 3, 50, 3);
  gives(AXISRT_ACTION_SET, order, 3, 0, 3);
  gives(AXISRT_ACTION_PROGRAM_END, 0, 0, 0, 0);
  gives(AXISRT_ACTION_SET, order, 8, 0, 1);
  gives(AXISRT_ACTION_ON, 0, 0, 0, 0);
  gives(AXISRT_ACTION_SET, quality, 0, 0, 2);
}

TEST_CASE("a command at rest does what the kernel does from then on") {
  TestRuntime switched(write_image(channel_image()));
  ImageRecord other = channel_image();
  other.slots[0].kernel = 1;
  TestRuntime listed(write_image(other));
  switched.reset_all(0);
  listed.reset_all(0);
  REQUIRE(switched.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 8) == AXISRT_OK);
  for (int cycle = 0; cycle < 100; ++cycle) {
    REQUIRE(switched.step(3.0 * cycle * cycle) == listed.step(3.0 * cycle * cycle));
  }
}

TEST_CASE("in motion the axes change over together, and a command meanwhile finds them busy") {
  TestRuntime runtime(write_image(channel_image()));
  runtime.reset_all(0);
  double position = 0;
  move(runtime, 50, position);
  CHECK(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_HSC) == AXISRT_OK);
  CHECK(runtime.state(0).fading == 0);  // the command reaches HSC filters only
  CHECK(runtime.state(1).fading == 1);
  CHECK(runtime.state(1).kernel == 2);
  for (int cycle = 0; cycle < 30; ++cycle) {
    CHECK(runtime.command(AXISRT_ACTION_OFF) == AXISRT_BUSY);
    CHECK(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_HSC) == AXISRT_BUSY);
    CHECK(runtime.state(1).fading == 1);
    move(runtime, 1, position);
  }
  CHECK(runtime.state(1).fading == 0);
  CHECK(runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
  CHECK(runtime.state(0).fading == 1);
  CHECK(runtime.state(1).fading == 1);
  move(runtime, 24, position);
  CHECK(runtime.command(AXISRT_ACTION_PROGRAM_END) == AXISRT_BUSY);
  move(runtime, 1, position);
  CHECK(runtime.state(0).fading == 0);
  // back to start-up: the longer of the fades to bank 0 and to off
  CHECK(runtime.command(AXISRT_ACTION_PROGRAM_END) == AXISRT_OK);
  move(runtime, 39, position);
  CHECK(runtime.state(0).fading == 1);
  move(runtime, 1, position);
  CHECK(runtime.state(0).fading == 0);
  CHECK(runtime.state(0).kernel == 0);
}

TEST_CASE("the end of a program fades as long as the slower of its two changes") {
  for (std::uint32_t const off : {5U, 60U}) {
    ImageRecord image = channel_image();
    image.groups[0].off_fade_cycles = off;
    TestRuntime runtime(write_image(image));
    runtime.reset_all(0);
    REQUIRE(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_HSC) == AXISRT_OK);
    double position = 0;
    move(runtime, 50, position);
    REQUIRE(runtime.command(AXISRT_ACTION_PROGRAM_END) == AXISRT_OK);
    int cycles = 0;
    for (; runtime.state(1).fading != 0; ++cycles) move(runtime, 1, position);
    CHECK(cycles == (off == 5 ? 40 : 60));
  }
}

TEST_CASE("a reset ends a fade") {
  TestRuntime runtime(write_image(channel_image()));
  runtime.reset_all(0);
  double position = 0;
  move(runtime, 50, position);
  REQUIRE(runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
  axisrt_reset(runtime.runtime, 0, 5);
  CHECK(runtime.state(0).fading == 0);
  CHECK(runtime.state(0).kernel == AXISRT_NO_KERNEL);
  CHECK(runtime.step(5) == 5);
}

TEST_CASE("what changes nothing is good at any time") {
  TestRuntime runtime(write_image(channel_image()));
  runtime.reset_all(0);
  double position = 0;
  move(runtime, 50, position);
  CHECK(runtime.command(AXISRT_ACTION_ON) == AXISRT_OK);
  CHECK(runtime.command(AXISRT_ACTION_SET) == AXISRT_OK);
  CHECK(runtime.command(AXISRT_ACTION_PROGRAM_END) == AXISRT_OK);
  CHECK(runtime.command(AXISRT_ACTION_SET, AXISRT_KEYWORD_HSC) == AXISRT_OK);  // it is off
  CHECK(runtime.state(0).fading == 0);
  CHECK(runtime.state(1).fading == 0);
}

TEST_CASE("parameters without a bank are refused, nothing is changed") {
  TestRuntime runtime(write_image(channel_image()));
  runtime.reset_all(0);
  CHECK(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 9) == AXISRT_NO_BANK);
  CHECK(runtime.command(AXISRT_ACTION_SET, AXISRT_KEYWORD_SHARE, 0, 50) == AXISRT_NO_BANK);
  CHECK(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER | AXISRT_KEYWORD_SHARE, 3, 51) ==
        AXISRT_NO_BANK);
  CHECK(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_HSC | AXISRT_KEYWORD_ORDER, 8) == AXISRT_NO_BANK);
  CHECK(runtime.command(AXISRT_ACTION_ON, 32) == AXISRT_NO_BANK);
  CHECK(runtime.state(0).kernel == 0);
  axisrt_filter_command command{.size = sizeof command,
                                .action = AXISRT_ACTION_ON,
                                .keywords = AXISRT_KEYWORD_FCUT,
                                .order = 0,
                                .share = 0,
                                .fcut = 81,
                                .quality = 0};
  CHECK(axisrt_command(runtime.runtime, 0, &command) == AXISRT_NO_BANK);
  command.fcut = 80;
  CHECK(axisrt_command(runtime.runtime, 0, &command) == AXISRT_OK);
  command.keywords = AXISRT_KEYWORD_QUALITY;
  command.quality = 0.25;
  CHECK(axisrt_command(runtime.runtime, 0, &command) == AXISRT_NO_BANK);
}

TEST_CASE("a bank without a gentle fade waits until every axis of the group stands") {
  TestRuntime runtime(write_image(channel_image()));
  runtime.reset_all(0);
  double position = 0;
  move(runtime, 50, position);
  CHECK(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 8) == AXISRT_NEEDS_STANDSTILL);
  CHECK(runtime.state(0).kernel == 0);
  rest(runtime, until_rest, position);
  CHECK(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 8) == AXISRT_OK);
  CHECK(runtime.state(0).kernel == 1);
  // The HSC axis alone is enough to make the group move.
  static_cast<void>(runtime.step_all({position, 1, 0}));
  CHECK(runtime.command(AXISRT_ACTION_ON, 0) == AXISRT_OK);
  CHECK(runtime.state(0).fading == 1);
  rest(runtime, until_rest, position);
  // An axis of the group without a filter is not looked at.
  static_cast<void>(runtime.step_all({position, 0, 5}));
  CHECK(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 8) == AXISRT_OK);
}

TEST_CASE("to standstill only counts the end of the program, too") {
  ImageRecord image = channel_image();
  image.groups[0].off_fade_cycles = 0;
  TestRuntime runtime(write_image(image));
  runtime.reset_all(0);
  double position = 0;
  CHECK(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_HSC) == AXISRT_OK);
  move(runtime, 50, position);
  CHECK(runtime.command(AXISRT_ACTION_PROGRAM_END) == AXISRT_NEEDS_STANDSTILL);
  CHECK(runtime.command(AXISRT_ACTION_OFF) == AXISRT_NEEDS_STANDSTILL);
}

TEST_CASE("bad arguments of a command are refused") {
  TestRuntime runtime(write_image(channel_image()));
  axisrt_filter_command command{};
  CHECK(axisrt_command(runtime.runtime, 0, &command) == AXISRT_BAD_ARGUMENT);
  command.size = sizeof command;
  CHECK(axisrt_command(nullptr, 0, &command) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_command(runtime.runtime, 0, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_command(runtime.runtime, 1, &command) == AXISRT_BAD_ARGUMENT);
  command.action = 4;
  CHECK(axisrt_command(runtime.runtime, 0, &command) == AXISRT_BAD_ARGUMENT);
}

TEST_CASE("ORDER_TIME means a whole number of cycles") {
  TestRuntime const runtime(write_image(channel_image()));
  CHECK(axisrt_order_of_time(runtime.runtime, 20'000) == 20);
  CHECK(axisrt_order_of_time(runtime.runtime, 20'499.999) == 20);
  CHECK(axisrt_order_of_time(runtime.runtime, 20'500) == 21);
  CHECK(axisrt_order_of_time(runtime.runtime, 1000) == 1);
  CHECK(axisrt_order_of_time(runtime.runtime, 999.999) == 0);
  for (double const none_at_all : {0.0, -5.0, static_cast<double>(NAN)}) {
    CHECK(axisrt_order_of_time(runtime.runtime, none_at_all) == 0);
  }
  CHECK(axisrt_order_of_time(nullptr, 20'000) == 0);
  CHECK(axisrt_order_of_time(runtime.runtime, 1e300) >= 201);
}

}  // namespace kernel_command_test
