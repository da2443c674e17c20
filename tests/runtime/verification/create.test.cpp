#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <string>

namespace create_test {

using namespace axisc::test;

namespace {

/// A configuration that works; tests change one thing.
struct Prepared {
  Prepared() : image(write_image(complete_image())), memory(1 << 16) {
    config = {.size = sizeof(axisrt_config),
              .cycle_time_ns = 1'000'000,
              .image = image.data(),
              .image_size = image.size(),
              .memory = memory.data(),
              .memory_size = memory.size(),
              .level = test_level(),
              .reserved = 0,
              .verify_signature = nullptr,
              .verify_context = nullptr};
  }
  axisrt_status create() { return axisrt_create(&config, &runtime); }

  AlignedMemory image;
  AlignedMemory memory;
  axisrt_config config{};
  axisrt* runtime = nullptr;
};

}  // namespace

TEST_CASE("create makes a runtime that knows its axes") {
  Prepared prepared;
  REQUIRE(prepared.create() == AXISRT_OK);
  CHECK(axisrt_axis_count(prepared.runtime) == 2);
  CHECK(axisrt_cycle_time_ns(prepared.runtime) == 1'000'000);
  CHECK(axisrt_image_version(prepared.runtime) == 7);
  CHECK(axisrt_has_interface(prepared.runtime, 0) == 0);
  CHECK(axisrt_has_interface(prepared.runtime, 1) == 1);
  CHECK(axisrt_has_interface(prepared.runtime, 2) == 0);
  std::size_t length = 0;
  char const* const name = axisrt_axis_name(prepared.runtime, 1, &length);
  CHECK(std::string(name, length) == "Spindel ä");
  CHECK(axisrt_axis_name(prepared.runtime, 2, &length) != nullptr);
  CHECK(length == 0);
}

TEST_CASE("a stripped image has no names but works") {
  ImageRecord image = complete_image();
  image.strip = true;
  TestRuntime runtime(write_image(image));
  REQUIRE(runtime.status == AXISRT_OK);
  std::size_t length = 1;
  CHECK(axisrt_axis_name(runtime.runtime, 0, &length) != nullptr);
  CHECK(length == 0);
}

TEST_CASE("the memory that memory_size demands is enough, and one byte less is not") {
  Prepared prepared;
  std::size_t bytes = 0;
  std::size_t alignment = 0;
  REQUIRE(axisrt_memory_size(&prepared.config, &bytes, &alignment) == AXISRT_OK);
  CHECK(alignment == AXISRT_ALIGNMENT);
  CHECK(bytes % alignment == 0);
  AlignedMemory exact(bytes);
  prepared.config.memory = exact.data();
  prepared.config.memory_size = bytes;
  CHECK(prepared.create() == AXISRT_OK);
  prepared.config.memory_size = bytes - 1;
  CHECK(prepared.create() == AXISRT_MEMORY_TOO_SMALL);
  CHECK(prepared.runtime == nullptr);
}

TEST_CASE("an image for another cycle time is refused") {
  Prepared prepared;
  prepared.config.cycle_time_ns = 2'000'000;
  CHECK(prepared.create() == AXISRT_OTHER_CYCLE_TIME);
  CHECK(prepared.runtime == nullptr);
}

TEST_CASE("create refuses what cannot be used") {
  Prepared prepared;
  std::size_t bytes = 0;
  SECTION("another size of the configuration") {
    prepared.config.size += 8;
  }
  SECTION("no memory") {
    prepared.config.memory = nullptr;
  }
  SECTION("no image") {
    prepared.config.image = nullptr;
  }
  SECTION("a reserved number") {
    prepared.config.reserved = 1;
    CHECK(axisrt_memory_size(&prepared.config, &bytes, &bytes) == AXISRT_BAD_ARGUMENT);
  }
  CHECK(prepared.create() == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_create(nullptr, &prepared.runtime) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_create(&prepared.config, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_memory_size(&prepared.config, nullptr, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_memory_size(nullptr, &bytes, &bytes) == AXISRT_BAD_ARGUMENT);
}

TEST_CASE("memory at an odd address is refused") {
  Prepared prepared;
  prepared.config.memory = prepared.memory.data() + 8;
  prepared.config.memory_size -= 8;
  CHECK(prepared.create() == AXISRT_MISALIGNED);
}

TEST_CASE("memory that overlaps the image is refused, and nothing is written") {
  Bytes const bytes = write_image(complete_image());
  Prepared prepared;
  std::size_t needed = 0;
  std::size_t alignment = 0;
  REQUIRE(axisrt_memory_size(&prepared.config, &needed, &alignment) == AXISRT_OK);
  constexpr std::size_t step = AXISRT_ALIGNMENT;
  std::size_t const image_blocks = (bytes.size() + step - 1) / step;
  std::size_t const memory_blocks = needed / step;
  // The image behind `memory_blocks` free blocks; memory from far in front of it to far behind it.
  AlignedMemory all((2 * memory_blocks + image_blocks + 1) * step);
  std::uint8_t* const image = all.data() + memory_blocks * step;
  std::copy(bytes.begin(), bytes.end(), image);
  prepared.config.image = image;
  prepared.config.memory_size = needed;
  for (std::size_t block = 0; block <= memory_blocks + image_blocks; ++block) {
    INFO(block);
    prepared.config.memory = all.data() + block * step;
    bool const apart = block == 0 || block == memory_blocks + image_blocks;
    REQUIRE(prepared.create() == (apart ? AXISRT_OK : AXISRT_BAD_ARGUMENT));
    REQUIRE((prepared.runtime != nullptr) == apart);
    REQUIRE(std::equal(bytes.begin(), bytes.end(), image));
  }
}

TEST_CASE("create and memory_size hand on what verify says") {
  Prepared prepared;
  prepared.config.image_size -= 64;
  std::size_t bytes = 0;
  std::size_t alignment = 0;
  CHECK(prepared.create() == AXISRT_TOO_SHORT);
  CHECK(axisrt_memory_size(&prepared.config, &bytes, &alignment) == AXISRT_TOO_SHORT);
}

TEST_CASE("the image is only read and not needed after create, except for names") {
  Bytes const bytes = write_image(complete_image());
  Prepared prepared;
  TestRuntime other(bytes);
  REQUIRE(prepared.create() == AXISRT_OK);
  CHECK(std::equal(bytes.begin(), bytes.end(), prepared.image.data()));
  std::fill_n(prepared.image.data(), prepared.image.size(), std::uint8_t{0});
  axisrt_reset(prepared.runtime, 0, 0);
  axisrt_reset(other.runtime, 0, 0);
  for (int i = 0; i < 20; ++i) {
    double const in[] = {100.0 * i, 0};
    double out[2] = {};
    axisrt_step(prepared.runtime, in, out, nullptr);
    REQUIRE(out[0] == other.step(100.0 * i));
  }
}

TEST_CASE("functions without a runtime answer harmlessly") {
  double value = 0;
  axisrt_axis_state state{};
  CHECK(axisrt_axis_count(nullptr) == 0);
  CHECK(axisrt_cycle_time_ns(nullptr) == 0);
  CHECK(axisrt_image_version(nullptr) == 0);
  CHECK(axisrt_has_interface(nullptr, 0) == 0);
  CHECK(axisrt_axis_name(nullptr, 0, nullptr) != nullptr);
  CHECK(axisrt_reset(nullptr, 0, 0) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_reset_interface(nullptr, 0, 0) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_rebase(nullptr, 0, 0) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_step(nullptr, &value, &value, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_step_interface(nullptr, &value, &value, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_get_axis_state(nullptr, 0, &state) == AXISRT_BAD_ARGUMENT);
  Prepared prepared;
  REQUIRE(prepared.create() == AXISRT_OK);
  CHECK(axisrt_step(prepared.runtime, nullptr, &value, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_step_interface(prepared.runtime, &value, nullptr, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_reset(prepared.runtime, 2, 0) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_reset_interface(prepared.runtime, 2, 0) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_get_axis_state(prepared.runtime, 0, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_get_axis_state(prepared.runtime, 2, &state) == AXISRT_BAD_ARGUMENT);
}

TEST_CASE("the automatic level is the best one of this processor") {
  TestRuntime automatic(write_image(complete_image()));
  REQUIRE(automatic.status == AXISRT_OK);
  std::uint32_t const level = axisrt_level_of(automatic.runtime);
  CHECK(level != AXISRT_LEVEL_AUTOMATIC);
  // Emulators say which processor they are.
  if (char const* const expected = std::getenv("AXISRT_TEST_EXPECTED_LEVEL")) {
    CHECK(level == std::strtoul(expected, nullptr, 10));
  }
}

}  // namespace create_test
