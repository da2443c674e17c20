// Golden images: every format version that was ever in use stays readable and executable.
#include "support/catch.hpp"
#include "support/file_contents.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace golden_test {

using namespace axisc::test;

namespace {

std::vector<std::filesystem::path> golden_images() {
  std::filesystem::path const folder = std::filesystem::path(AXISC_SOURCE_DIR) / "tests/data/images";
  std::vector<std::filesystem::path> images;
  if (!std::filesystem::is_directory(folder)) return images;
  for (auto const& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".axim") images.push_back(entry.path());
  }
  std::sort(images.begin(), images.end());
  return images;
}

Bytes read_file(std::filesystem::path const& path) {
  auto const contents = file_contents(path);
  return {contents.begin(), contents.end()};
}

std::vector<double> additive_velocities(TestRuntime& runtime, double v) {
  std::vector<double> const velocity(axisrt_axis_count(runtime.runtime), v);
  std::vector<double> v_add(velocity.size());
  axisrt_velocities velocities{};
  velocities.size = sizeof velocities;
  velocities.v_set = velocities.v_motor = velocities.v_direct = velocity.data();
  REQUIRE(axisrt_step_velocity(runtime.runtime, &velocities, v_add.data(), nullptr, nullptr) == AXISRT_OK);
  return v_add;
}

bool are_finite(std::vector<double> const& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

TEST_CASE("golden images are verified, pass their self-tests and run") {
  for (std::filesystem::path const& path : golden_images()) {
    INFO(path.filename().string());
    Bytes const image = read_file(path);
    TestRuntime runtime(image, static_cast<std::uint32_t>(peek(image, 32, 4)));
    REQUIRE(runtime.status == AXISRT_OK);
    for (std::uint32_t axis = 0; axis < axisrt_axis_count(runtime.runtime); ++axis) {
      REQUIRE(axisrt_reset(runtime.runtime, axis, 1e6) == AXISRT_OK);
      REQUIRE(axisrt_reset_interface(runtime.runtime, axis, 0) == AXISRT_OK);
      REQUIRE(axisrt_reset_velocity(runtime.runtime, axis, 0, 0, 0) == AXISRT_OK);
    }
    bool const has_channel = axisrt_group_count(runtime.runtime) > 0;
    CHECK(has_channel == (peek(image, 6, 2) > 0));  // those of format 1.0 cannot have one
    for (int cycle = 0; cycle < 1000; ++cycle) {
      if (cycle == 500 && has_channel) CHECK(runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
      REQUIRE(std::isfinite(runtime.step(1e6 + 10.0 * cycle)));
      REQUIRE(runtime.status == AXISRT_OK);
      REQUIRE(are_finite(additive_velocities(runtime, 1000 * std::sin(cycle * 0.3))));
    }
  }
}

}  // namespace golden_test
