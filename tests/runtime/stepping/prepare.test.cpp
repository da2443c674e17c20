// What axisrt_prepare compares before one image replaces another.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace prepare_test {

using namespace axisc::test;

namespace {

/// A runtime whose image and memory the test has at hand.
struct Made {
  explicit Made(ImageRecord const& record, axisrt* active = nullptr) : Made(write_image(record), active) {}
  explicit Made(Bytes const& bytes, axisrt* active = nullptr)
      : image(std::make_unique<AlignedMemory>(bytes)) {
    config.size = sizeof config;
    config.cycle_time_ns = 1'000'000;
    config.image = image->data();
    config.image_size = image->size();
    config.level = test_level();
    std::size_t size = 0;
    std::size_t alignment = 0;
    REQUIRE(axisrt_memory_size(&config, &size, &alignment) == AXISRT_OK);
    memory = std::make_unique<AlignedMemory>(size);
    config.memory = memory->data();
    config.memory_size = memory->size();
    status =
        active == nullptr ? axisrt_create(&config, &runtime) : axisrt_prepare(active, &config, 0, &runtime);
  }

  std::unique_ptr<AlignedMemory> image;
  std::unique_ptr<AlignedMemory> memory;
  axisrt_config config{};
  axisrt* runtime = nullptr;
  axisrt_status status = AXISRT_OK;
};

ImageRecord without_control() {
  ImageRecord image;
  image.axes.resize(1);
  return image;
}

/// A stage that subtracts the commanded velocity.
ImageRecord with_control(double scale) {
  FilterRecord pass;
  pass.realisation = 0;
  ImageRecord image = without_control();
  image.controls = {{.axis = 0,
                     .source = 0,
                     .stages = {{.index = 0, .mode = 3, .weight = 1, .filters = {pass}}},
                     .limit = 1e9,
                     .scale = scale}};
  return image;
}

/// Steps both in a motion, until the filters have seen enough of it.
void shadow(Made const& active, Made const& prepared) {
  std::vector<double> out(axisrt_axis_count(active.runtime));
  for (int cycle = 0; cycle < 200; ++cycle) {
    std::vector<double> const in(out.size(), 1000.0 + 10 * cycle);
    REQUIRE(axisrt_step(active.runtime, in.data(), out.data(), nullptr) == AXISRT_OK);
    REQUIRE(axisrt_shadow_step(prepared.runtime) == AXISRT_OK);
  }
}

/// What a swap in motion answers.
axisrt_status swap_in_motion(ImageRecord const& before, ImageRecord const& behind) {
  Made const active(before);
  for (std::uint32_t axis = 0; axis < axisrt_axis_count(active.runtime); ++axis) {
    REQUIRE(axisrt_reset(active.runtime, axis, 1000) == AXISRT_OK);
    REQUIRE(axisrt_reset_velocity(active.runtime, axis, 0, 0, 0) == AXISRT_OK);
  }
  Made const prepared(behind, active.runtime);
  REQUIRE(prepared.status == AXISRT_OK);
  shadow(active, prepared);
  return axisrt_swap(prepared.runtime);
}

}  // namespace

TEST_CASE("position control is the same only if every number of it is") {
  CHECK(swap_in_motion(without_control(), without_control()) == AXISRT_OK);
  CHECK(swap_in_motion(with_control(1000), with_control(1000)) == AXISRT_OK);
  // Chosen such that the CRC-32C over all numbers of the control is 0, that of nothing.
  CHECK(swap_in_motion(without_control(), with_control(0x1.f400045fe35fcp+9)) == AXISRT_NEEDS_STANDSTILL);
  CHECK(swap_in_motion(with_control(0x1.f400045fe35fcp+9), without_control()) == AXISRT_NEEDS_STANDSTILL);
  // The same CRC-32C as with 1000.
  CHECK(swap_in_motion(with_control(1000), with_control(0x1.f400105ec76f1p+9)) == AXISRT_NEEDS_STANDSTILL);
}

TEST_CASE("each number of position control counts") {
  ImageRecord const before = channel_image();
  REQUIRE(swap_in_motion(before, before) == AXISRT_OK);
  std::vector<ImageRecord> changed(7, before);
  changed[0].controls[0].limit += 1;
  changed[1].controls[1].scale = -changed[1].controls[1].scale;
  changed[2].controls[0].stages[1].weight *= 0.5;
  changed[3].controls[0].stages[0].mode = 3;
  changed[4].controls[0].stages.pop_back();
  changed[5].controls.pop_back();
  changed[6].controls[0].stages[0].filters[0].sections[0].p *= 0.5;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    INFO(i);
    CHECK(swap_in_motion(before, changed[i]) == AXISRT_NEEDS_STANDSTILL);
  }
}

namespace {

ImageRecord named(std::string const& name) {
  ImageRecord image = without_control();
  image.axes[0].name = name;
  return image;
}

/// What prepare answers when the image of the runtime that works is gone.
axisrt_status prepare_without_image(ImageRecord const& before, ImageRecord const& behind) {
  Made active(before);
  std::fill_n(active.image->data(), active.image->size(), std::uint8_t{0x55});
  active.image.reset();
  return Made(behind, active.runtime).status;
}

}  // namespace

TEST_CASE("prepare compares names without the image of the runtime that works") {
  ImageRecord stripped = named("X");
  stripped.strip = true;
  CHECK(prepare_without_image(named("X"), named("X")) == AXISRT_OK);
  CHECK(prepare_without_image(named("X"), named("Y")) == AXISRT_OTHER_AXES);
  CHECK(prepare_without_image(named("X"), named("XX")) == AXISRT_OTHER_AXES);
  CHECK(prepare_without_image(named("X"), stripped) == AXISRT_OK);
  CHECK(prepare_without_image(stripped, named("X")) == AXISRT_OK);
}

TEST_CASE("prepare leaves the memory of the runtime that works alone, and of its recorder") {
  Bytes const image = write_image(channel_image());
  Made const active(image);
  REQUIRE(active.status == AXISRT_OK);
  axisrt_config config = active.config;
  axisrt* prepared = nullptr;
  CHECK(axisrt_prepare(active.runtime, &config, 0, &prepared) == AXISRT_BAD_ARGUMENT);
  CHECK(prepared == nullptr);
  std::vector<double> out(axisrt_axis_count(active.runtime));
  CHECK(axisrt_step(active.runtime, out.data(), out.data(), nullptr) == AXISRT_NOT_RESET);

  std::size_t size = 0;
  REQUIRE(axisrt_recorder_size(active.runtime, &config, 100, &size) == AXISRT_OK);
  AlignedMemory recording(size);
  config.memory = recording.data();
  config.memory_size = recording.size();
  axisrt_recorder* recorder = nullptr;
  REQUIRE(axisrt_recorder_start(active.runtime, &config, 100, &recorder) == AXISRT_OK);
  CHECK(axisrt_prepare(active.runtime, &config, 0, &prepared) == AXISRT_BAD_ARGUMENT);
  axisrt_recorder_stop(recorder);
  CHECK(axisrt_prepare(active.runtime, &config, 0, &prepared) == AXISRT_OK);
}

}  // namespace prepare_test
