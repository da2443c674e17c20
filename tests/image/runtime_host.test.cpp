#include "image/runtime_host.hpp"

#include "codegen/image_writer.hpp"
#include "support/catch.hpp"
#include "tests/codegen/machines.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace axisc::codegen {
namespace {

std::vector<std::byte> sample_image() {
  return write_image(test::sample_machine(), {});
}

axisrt_status refusal(std::variant<image::RuntimeHost, axisrt_status> const& result) {
  return std::holds_alternative<axisrt_status>(result) ? std::get<axisrt_status>(result) : AXISRT_OK;
}

}  // namespace

TEST_CASE("a runtime knows its axes", "[runtime-host]") {
  image::RuntimeHost const runtime = test::runtime_for(sample_image());
  CHECK(runtime.axis_count() == 4);
  CHECK(runtime.cycle_time().nanoseconds == 1'000'000);
  CHECK(runtime.axis_name(2) == "Ä");
  CHECK(runtime.axis_name(4).empty());
  CHECK(runtime.has_interface(0));
  CHECK_FALSE(runtime.has_interface(1));
  CHECK(runtime.memory_size() > 0);
}

TEST_CASE("a runtime refuses what it cannot run", "[runtime-host]") {
  std::vector<std::byte> image = sample_image();
  CHECK(refusal(image::RuntimeHost::create(image, design::CycleTime{1'000'000})) == AXISRT_OK);
  CHECK(refusal(image::RuntimeHost::create(image, design::CycleTime{500'000})) == AXISRT_OTHER_CYCLE_TIME);
  CHECK(refusal(image::RuntimeHost::create({})) == AXISRT_TOO_SHORT);
  image.back() ^= std::byte{1};
  CHECK(refusal(image::RuntimeHost::create(image)) == AXISRT_WRONG_CHECKSUM);
}

TEST_CASE("axes are reset before they are filtered", "[runtime-host]") {
  image::RuntimeHost runtime = test::runtime_for(sample_image());
  std::array<double, 4> const setpoints = {100, 100, 100, 100};
  std::array<double, 4> outputs{};
  std::array<std::uint8_t, 4> status{};
  CHECK(runtime.step(setpoints, outputs, status) == AXISRT_NOT_RESET);
  CHECK(outputs == setpoints);

  CHECK(runtime.reset(0, 100) == AXISRT_OK);
  CHECK(runtime.step(setpoints, outputs, status) == AXISRT_NOT_RESET);
  CHECK(status ==
        std::array<std::uint8_t, 4>{AXISRT_OK, AXISRT_NOT_RESET, AXISRT_NOT_RESET, AXISRT_NOT_RESET});
  CHECK(runtime.reset_all(100) == AXISRT_OK);
  CHECK(runtime.step(setpoints, outputs, status) == AXISRT_OK);
  CHECK(runtime.reset(4, 0) == AXISRT_BAD_ARGUMENT);
}

TEST_CASE("arrays have one entry per axis", "[runtime-host]") {
  image::RuntimeHost runtime = test::runtime_for(sample_image());
  CHECK(runtime.reset_all(0) == AXISRT_OK);
  std::array<double, 5> values{};
  std::array<std::uint8_t, 3> status{};
  std::span<double> const four = std::span(values).first(4);
  CHECK(runtime.step(values, four) == AXISRT_BAD_ARGUMENT);
  CHECK(runtime.step(four, values) == AXISRT_BAD_ARGUMENT);
  CHECK(runtime.step(four, four, status) == AXISRT_BAD_ARGUMENT);
  CHECK(runtime.step_interface(four, values) == AXISRT_BAD_ARGUMENT);
  CHECK(runtime.step(four, four) == AXISRT_OK);
}

TEST_CASE("a runtime can be moved", "[runtime-host]") {
  image::RuntimeHost first = test::runtime_for(sample_image());
  CHECK(first.reset_all(7) == AXISRT_OK);
  image::RuntimeHost second = std::move(first);
  std::array<double, 4> values = {7, 7, 7, 7};
  CHECK(second.step(values, values) == AXISRT_OK);
  CHECK(values[0] == 7);
  auto const state = second.axis_state(0);
  REQUIRE(std::holds_alternative<axisrt_axis_state>(state));
  CHECK(std::get<axisrt_axis_state>(state).filters == 2);
  CHECK(std::get<axisrt_axis_state>(state).settled == 1);
  CHECK(std::holds_alternative<axisrt_status>(second.axis_state(4)));
}

TEST_CASE("a bad setpoint is reported and does no harm", "[runtime-host]") {
  image::RuntimeHost runtime = test::runtime_for(sample_image());
  CHECK(runtime.reset_all(5) == AXISRT_OK);
  std::array<double, 4> values = {5, std::numeric_limits<double>::quiet_NaN(), 5, 5};
  std::array<std::uint8_t, 4> status{};
  CHECK(runtime.step(values, values, status) == AXISRT_BAD_INPUT);
  CHECK(status[1] == AXISRT_BAD_INPUT);
  CHECK(std::isfinite(values[1]));
}

TEST_CASE("commands reach the bank of their parameters", "[runtime-host]") {
  machine::Machine const machine = test::kernel_machine();
  image::RuntimeHost runtime = test::runtime_for(write_image(machine, {}));
  image::ImageContents const contents = test::contents_of(write_image(machine, {}));
  CHECK(runtime.reset_all(0) == AXISRT_OK);
  CHECK(runtime.group_count() == 2);
  auto const kernel_of = [&](std::uint32_t axis) {
    return std::get<axisrt_axis_state>(runtime.axis_state(axis)).kernel;
  };
  machine::FilterCommand command;
  command.filter_switch = machine::FilterSwitch::on;
  for (image::ImageBank const& bank : contents.groups[0].banks) {
    command.parameters = bank.parameters;
    command.hsc = bank.hsc;
    CHECK(runtime.command(0, command) == AXISRT_OK);
    std::uint32_t const axis = bank.hsc ? 2 : 0;
    CHECK(kernel_of(axis) == bank.kernels[bank.hsc ? 3 : 0].value_or(AXISRT_NO_KERNEL));
  }
  command.hsc = false;
  command.parameters = test::filter_set(41);
  CHECK(runtime.command(0, command) == AXISRT_NO_BANK);
  command.parameters = {};
  CHECK(runtime.command(0, command) == AXISRT_OK);
  command.filter_switch = machine::FilterSwitch::off;
  CHECK(runtime.command(0, command) == AXISRT_OK);
  CHECK(kernel_of(0) == AXISRT_NO_KERNEL);
  command.filter_switch = machine::FilterSwitch::unchanged;
  command.parameters = test::filter_set(40);
  CHECK(runtime.command(0, command) == AXISRT_OK);
  CHECK(kernel_of(0) == AXISRT_NO_KERNEL);
  CHECK(runtime.end_program(0) == AXISRT_OK);
  CHECK(kernel_of(0) == contents.axes[0].slot->kernel);
  CHECK(runtime.command(2, command) == AXISRT_BAD_ARGUMENT);
  CHECK(runtime.end_program(2) == AXISRT_BAD_ARGUMENT);
}

TEST_CASE("velocities have one entry per axis, the direct ones may be missing", "[runtime-host]") {
  image::RuntimeHost runtime = test::runtime_for(write_image(test::kernel_machine(), {}));
  CHECK(runtime.has_position_control(0));
  CHECK_FALSE(runtime.has_position_control(1));
  CHECK(runtime.reset_all(0) == AXISRT_OK);
  std::array<double, 5> const v = {100, 100, 100, 100, 100};
  std::array<double, 5> v_add{};
  std::array<double, 5> increments{};
  std::array<std::uint8_t, 5> status{};
  std::span<double const> const four = std::span(v).first(4);
  CHECK(runtime.step_velocity({.set = v, .motor = v, .direct = v}, v_add, increments, status) == AXISRT_OK);
  CHECK(v_add[0] != 0);
  CHECK(v_add[3] == v_add[0]);
  CHECK(increments[3] == Approx(v_add[0] * 6e-5 * 8 / 3).epsilon(1e-15));
  CHECK(runtime.step_velocity({.set = v, .motor = v, .direct = {}}, v_add, increments) == AXISRT_OK);
  CHECK(runtime.step_velocity({.set = four, .motor = v, .direct = v}, v_add, increments) ==
        AXISRT_BAD_ARGUMENT);
  CHECK(runtime.step_velocity({.set = v, .motor = four, .direct = v}, v_add, increments) ==
        AXISRT_BAD_ARGUMENT);
  CHECK(runtime.step_velocity({.set = v, .motor = v, .direct = four}, v_add, increments) ==
        AXISRT_BAD_ARGUMENT);
  CHECK(runtime.step_velocity({.set = v, .motor = v, .direct = v}, std::span(v_add).first(4), increments) ==
        AXISRT_BAD_ARGUMENT);
  CHECK(runtime.reset_velocity(0, NAN, 0, 0) == AXISRT_BAD_INPUT);
  CHECK(runtime.reset_velocity(5, 0, 0, 0) == AXISRT_BAD_ARGUMENT);
}

TEST_CASE("the additional interface has filters of its own", "[runtime-host]") {
  image::RuntimeHost runtime = test::runtime_for(sample_image());
  CHECK(runtime.reset_all(0) == AXISRT_OK);
  std::array<double, 4> const step = {1, 1, 1, 1};
  std::array<double, 4> outputs{};
  CHECK(runtime.step_interface(step, outputs) == AXISRT_OK);
  CHECK(outputs[0] > 0);
  CHECK(outputs[0] < 0.01);
  CHECK(outputs[1] == 1);
}

}  // namespace axisc::codegen
