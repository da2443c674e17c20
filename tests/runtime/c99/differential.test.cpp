// axisrt_c is axisrt at level portable: no bit differs, whatever the image, the setpoints and the commands
// are.
#include "support/catch.hpp"
#include "support/file_contents.hpp"
#include "tests/runtime/c99/motion.hpp"
#include "tests/runtime/c99/random_image.hpp"
#include "tests/runtime/c99/twins.hpp"

#include <filesystem>
#include <vector>

using namespace axisc::test;

namespace {

struct Counts {
  std::uint64_t values = 0, commands = 0;
};

Counts run_random_images(std::uint32_t first, std::uint32_t last) {
  Counts counts;
  for (std::uint32_t seed = first; seed < last; ++seed) {
    Twins twins(write_image(random_image(seed)));
    INFO("seed " << seed);
    REQUIRE(twins.c.status == AXISRT_C_OK);
    Random random(seed);
    move(random, twins, static_cast<int>(random.chance(4) ? 3000 : 300));
    REQUIRE(twins.difference == "");
    counts.values += twins.values;
    counts.commands += twins.commands_done;
  }
  return counts;
}

}  // namespace

TEST_CASE("axisrt_c computes golden images bit for bit") {
  std::filesystem::path const folder = std::filesystem::path(AXISC_SOURCE_DIR) / "tests/data/images";
  if (!std::filesystem::is_directory(folder)) return;
  for (auto const& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".axim") continue;
    INFO(entry.path().filename().string());
    auto const image = file_contents(entry.path());
    Twins twins(Bytes(image.begin(), image.end()));
    REQUIRE(twins.c.status == AXISRT_C_OK);
    Random random(1);
    move(random, twins, 3000);
    CHECK(twins.difference == "");
  }
}

TEST_CASE("axisrt_c computes images of these tests bit for bit") {
  for (ImageRecord const& image : {complete_image(), channel_image()}) {
    Twins twins(write_image(image));
    REQUIRE(twins.c.status == AXISRT_C_OK);
    Random random(2);
    move(random, twins, 3000);
    CHECK(twins.difference == "");
  }
}

TEST_CASE("axisrt_c computes random images with commands at random cycles bit for bit") {
  Counts const counts = run_random_images(0, 50);
  CHECK(counts.values > 1'000'000);
  CHECK(counts.commands > 300);
}

TEST_CASE("axisrt_c computes ten thousand random images bit for bit", "[.long]") {
  Counts const counts = run_random_images(50, 10'050);
  WARN(counts.values << " values and " << counts.commands << " commands were equal");
}

TEST_CASE("a copy of the block, put back, restores the state of axisrt_c") {
  CRuntime runtime(write_image(channel_image()));
  REQUIRE(runtime.status == AXISRT_C_OK);
  std::vector<double> in(axisrt_c_axis_count(runtime.runtime), 0);
  std::vector<double> out(in.size());
  for (std::uint32_t axis = 0; axis < in.size(); ++axis) axisrt_c_reset(runtime.runtime, axis, 0);
  auto const run = [&] {
    std::vector<double> outputs;
    for (int cycle = 0; cycle < 50; ++cycle) {
      in.assign(in.size(), 1000.0 * cycle);
      if (cycle == 20) axisrt_c_command(runtime.runtime, 0, AXISRT_C_OFF, 0);
      axisrt_c_step(runtime.runtime, in.data(), out.data(), nullptr);
      outputs.insert(outputs.end(), out.begin(), out.end());
    }
    return outputs;
  };
  auto const before = runtime.block();
  auto const outputs = run();
  runtime.restore(before);
  CHECK(run() == outputs);
}
