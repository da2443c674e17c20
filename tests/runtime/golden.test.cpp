// Golden images: every format version that was ever in use stays readable and executable.
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

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
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
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
    }
    for (int cycle = 0; cycle < 1000; ++cycle) REQUIRE(std::isfinite(runtime.step(1e6 + 10.0 * cycle)));
    CHECK(runtime.status == AXISRT_OK);
  }
}
