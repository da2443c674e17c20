// Worked examples, the arithmetic written out; v_add in um/s or 1e-3 degree/s, the drive's distance unit is 1
// um or 0.001 degree.
#include "codegen/velocity_scaling.hpp"

#include "codegen/image_writer.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <array>

namespace axisc::codegen {
namespace {

using machine::DriveScaling;
using machine::PositionController;

/// Drive increments that the runtime gives for an additive velocity of 1000 um/s.
double increments_for_1000(DriveScaling const& scaling, design::CycleTime cycle_time) {
  machine::Machine machine = test::machine_with({}, cycle_time);
  machine::PositionControlStage stage;
  stage.mode = machine::StageMode::set_point;
  stage.filters = {{.type = design::FilterType::time_delay, .time_constant = {0}}};  // passes
  machine.axes[0].position_control = {.stages = {stage}, .limit_factor = 1000};
  machine.axes[0].drive_scaling = scaling;
  image::RuntimeHost runtime = test::runtime_for(write_image(machine, {}));
  CHECK(runtime.reset_velocity(0, -1000, 0, 0) == AXISRT_OK);
  std::array<double, 1> const set = {-1000};
  std::array<double, 1> const motor = {0};
  std::array<double, 1> v_add{};
  std::array<double, 1> increments{};
  CHECK(runtime.step_velocity({.set = set, .motor = motor, .direct = {}}, v_add, increments) == AXISRT_OK);
  CHECK(v_add[0] == 1000);
  return increments[0];
}

}  // namespace

TEST_CASE("position control in the drive, per minute", "[position-control]") {
  // 10 increments per um: 1000 um/s are 60,000 um/min, 600,000 increments a minute.
  DriveScaling const scaling{.controller = PositionController::drive,
                             .v_reso_num = 10,
                             .v_reso_denom = 1,
                             .time_base = 0,
                             .multi_gain_z = 1,
                             .multi_gain_n = 1};
  CHECK(increments_for_1000(scaling, {1'000'000}) == 600'000);
}

TEST_CASE("position control in the drive, per second", "[position-control]") {
  // 3 increments per 8 um: 1000 um/s are 375 increments a second, at any cycle time.
  DriveScaling const scaling{.controller = PositionController::drive,
                             .v_reso_num = 3,
                             .v_reso_denom = 8,
                             .time_base = 1,
                             .multi_gain_z = 1,
                             .multi_gain_n = 1};
  CHECK(increments_for_1000(scaling, {1'000'000}) == 375);
  CHECK(increments_for_1000(scaling, {125'000}) == 375);
}

TEST_CASE("position control in the drive, per sampling interval", "[position-control]") {
  // 256 increments per um: 1000 um/s are 0.5 um in 500 us, 128 increments.
  DriveScaling const scaling{.controller = PositionController::drive,
                             .v_reso_num = 256,
                             .v_reso_denom = 1,
                             .time_base = 2,
                             .multi_gain_z = 1,
                             .multi_gain_n = 1};
  CHECK(increments_for_1000(scaling, {500'000}) == 128);
}

TEST_CASE("position control in the CNC", "[position-control]") {
  // z/n = 8192/3 increments at 1 m/min. 1000 um/s are 0.06 m/min: 0.06 * 8192 / 3 = 163.84 increments.
  DriveScaling const scaling{.controller = PositionController::cnc,
                             .v_reso_num = 77,
                             .v_reso_denom = 7,
                             .time_base = 2,
                             .multi_gain_z = 8192,
                             .multi_gain_n = 3};
  CHECK(increments_for_1000(scaling, {1'000'000}) == Approx(163.84).epsilon(1e-15));
  // 1 m/min at 16,666.66... um/s gives z/n itself.
  CHECK(increments_per_velocity(scaling, {}) * 1e6 / 60 == Approx(8192.0 / 3).epsilon(1e-15));
}

TEST_CASE("without a known position control there are no increments", "[position-control]") {
  CHECK(increments_for_1000({.v_reso_num = 10}, {1'000'000}) == 0);
}

TEST_CASE("a weight is a quotient, at most 7", "[position-control]") {
  machine::PositionControlStage stage;
  stage.weight_numerator = 300;
  stage.weight_denominator = 100;
  CHECK(stage_weight(stage) == 3);
  stage.weight_numerator = 190;
  CHECK(stage_weight(stage) == 1.9);
  stage.weight_numerator = 700;
  CHECK(stage_weight(stage) == 7);
  stage.weight_numerator = 701;
  CHECK(stage_weight(stage) == 7);
  stage.weight_numerator = 0;
  CHECK(stage_weight(stage) == 0);
}

TEST_CASE("the limit is a share of the axis' velocity", "[position-control]") {
  CHECK(velocity_limit({.stages = {}, .limit_factor = 1000}, 500'000) == 500'000);
  CHECK(velocity_limit({.stages = {}, .limit_factor = 125}, 500'000) == 62'500);
  CHECK(velocity_limit({.stages = {}, .limit_factor = 0}, 500'000) == 0);
}

}  // namespace axisc::codegen
