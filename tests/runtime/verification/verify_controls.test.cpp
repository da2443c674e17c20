// What verify asks of Improved Position Control.
#include "support/catch.hpp"
#include "tests/runtime/mutation.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <vector>

namespace verify_controls_test {

using namespace axisc::test;

namespace {

/// Filters 2 to 4 are those of the stages.
std::vector<Mutation> mutations() {
  return {
      u32("axis of a control", controls_kind, 1, 0, 3, AXISRT_OUT_OF_BOUNDS),
      u32("controls out of order", controls_kind, 1, 0, 0, AXISRT_OUT_OF_BOUNDS),
      u32("source behind the end", controls_kind, 1, 4, 3, AXISRT_OUT_OF_BOUNDS),
      u32("source without a control", controls_kind, 1, 4, 1, AXISRT_OUT_OF_BOUNDS),
      u32("own source without stages", controls_kind, 1, 4, 2, AXISRT_OUT_OF_BOUNDS),
      u32("master that is a slave", controls_kind, 0, 4, 2, AXISRT_OUT_OF_BOUNDS),
      u32("first stage", controls_kind, 0, 8, 1, AXISRT_OUT_OF_BOUNDS),
      u32("a stage too few", controls_kind, 0, 12, 1, AXISRT_OUT_OF_BOUNDS),
      u32("a stage too many", controls_kind, 0, 12, 3, AXISRT_OUT_OF_BOUNDS),
      u32("four stages", controls_kind, 0, 12, 4, AXISRT_OUT_OF_BOUNDS),
      u32("slave with stages", controls_kind, 1, 12, 1, AXISRT_OUT_OF_BOUNDS),
      u32("controller", controls_kind, 0, 16, 3, AXISRT_UNKNOWN_KIND),
      u32("time base", controls_kind, 0, 20, 3, AXISRT_OUT_OF_BOUNDS),
      f64("limit", controls_kind, 0, 24, not_a_number, AXISRT_NOT_FINITE),
      f64("no limit", controls_kind, 0, 24, infinity, AXISRT_NOT_FINITE),
      f64("limit below 0", controls_kind, 0, 24, -1, AXISRT_OUT_OF_BOUNDS),
      f64("limit too large", controls_kind, 0, 24, 0x1p101, AXISRT_OUT_OF_BOUNDS),
      f64("limit 0", controls_kind, 0, 24, 0, AXISRT_OK),
      f64("scale", controls_kind, 1, 32, infinity, AXISRT_NOT_FINITE),
      f64("scale too large", controls_kind, 1, 32, -0x1p101, AXISRT_OUT_OF_BOUNDS),
      f64("scale below 0", controls_kind, 1, 32, -3, AXISRT_OK),
      f64("limit factor", controls_kind, 0, 40, not_a_number, AXISRT_NOT_FINITE),
      f64("v_reso_num", controls_kind, 0, 48, not_a_number, AXISRT_NOT_FINITE),
      f64("v_reso_denom", controls_kind, 0, 56, not_a_number, AXISRT_NOT_FINITE),
      f64("multi_gain_z", controls_kind, 0, 64, not_a_number, AXISRT_NOT_FINITE),
      f64("multi_gain_n", controls_kind, 0, 72, not_a_number, AXISRT_NOT_FINITE),
      u32("index of a stage", stages_kind, 1, 0, 3, AXISRT_OUT_OF_BOUNDS),
      u32("mode 0", stages_kind, 0, 4, 0, AXISRT_UNKNOWN_KIND),
      u32("mode 4", stages_kind, 0, 4, 4, AXISRT_UNKNOWN_KIND),
      u32("mode 3", stages_kind, 0, 4, 3, AXISRT_OK),
      u32("first filter", stages_kind, 1, 8, 2, AXISRT_OUT_OF_BOUNDS),
      u32("no filter", stages_kind, 0, 12, 0, AXISRT_OUT_OF_BOUNDS),
      u32("a filter too many", stages_kind, 0, 12, 2, AXISRT_OUT_OF_BOUNDS),
      u32("four filters", stages_kind, 0, 12, 4, AXISRT_OUT_OF_BOUNDS),
      u32("a filter too few", stages_kind, 1, 12, 1, AXISRT_OUT_OF_BOUNDS),
      f64("weight", stages_kind, 0, 16, not_a_number, AXISRT_NOT_FINITE),
      f64("weight below 0", stages_kind, 0, 16, -0.5, AXISRT_OUT_OF_BOUNDS),
      f64("weight 7", stages_kind, 0, 16, 7, AXISRT_OK),
      f64("weight above 7", stages_kind, 0, 16, 7.5, AXISRT_OUT_OF_BOUNDS),
      f64("numerator", stages_kind, 0, 24, infinity, AXISRT_NOT_FINITE),
      f64("denominator", stages_kind, 0, 32, not_a_number, AXISRT_NOT_FINITE),
      u32("filter of another axis", filters_kind, 2, 0, 1, AXISRT_OUT_OF_BOUNDS),
      u32("filter of another port", filters_kind, 2, 4, 0, AXISRT_OUT_OF_BOUNDS),
      u32("filters of a stage out of order", filters_kind, 4, 8, 0, AXISRT_OUT_OF_BOUNDS),
      u32("oscillator", filters_kind, 2, 36, 0, AXISRT_OK),
      entry("controls without stages", stages_kind, 28, 0, 4, AXISRT_OUT_OF_BOUNDS),
  };
}

}  // namespace

TEST_CASE("each fault of position control has its status") {
  check_mutations(channel_image(), mutations());
}

TEST_CASE("filters of stages belong to a stage") {
  ImageRecord image = channel_image();
  image.controls.clear();
  CHECK(verify(write_image(image)) == AXISRT_OK);
  image = channel_image();
  image.controls[1].axis = 1;
  image.controls[1].source = 2;  // an axis without a control
  CHECK(verify(write_image(image)) == AXISRT_OUT_OF_BOUNDS);
}

TEST_CASE("a gantry slave's master is none") {
  ImageRecord image = channel_image();
  image.controls.insert(image.controls.begin() + 1, {.axis = 1, .source = 0, .stages = {}});
  CHECK(verify(write_image(image)) == AXISRT_OK);
  image.controls[1].source = 2;
  CHECK(verify(write_image(image)) == AXISRT_OUT_OF_BOUNDS);
}

TEST_CASE("stages are one to three, a slave's none, each of them with a filter") {
  ImageRecord image = channel_image();
  StageRecord const direct = image.controls[0].stages[0];
  image.controls[0].stages = {direct, direct, direct};
  CHECK(verify(write_image(image)) == AXISRT_OK);
  image.controls[0].stages.push_back(direct);
  CHECK(verify(write_image(image)) == AXISRT_OUT_OF_BOUNDS);
  image = channel_image();
  image.controls[1].stages = {direct};
  CHECK(verify(write_image(image)) == AXISRT_OUT_OF_BOUNDS);
  image = channel_image();
  image.controls[0].stages[1].filters.clear();
  CHECK(verify(write_image(image)) == AXISRT_OUT_OF_BOUNDS);
  check_mutations(image, {u32("stage that is left over", controls_kind, 0, 12, 1, AXISRT_OUT_OF_BOUNDS)});
}

TEST_CASE("an image has stages only for its controls") {
  // The entry of the controls becomes one that may be skipped: nobody claims the stages then.
  check_mutations(channel_image(), {{"controls skipped",
                                     [](Bytes& b) {
                                       std::size_t const at = entry_offset(b, controls_kind);
                                       poke(b, at, 99, 4);
                                       poke(b, at + 4, 1, 4);
                                     },
                                     AXISRT_OUT_OF_BOUNDS}});
}

}  // namespace verify_controls_test
