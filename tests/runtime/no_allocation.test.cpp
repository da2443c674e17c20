// Nothing of the runtime allocates, neither in the cycle nor before it.
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

using namespace axisc::test;

namespace {
std::atomic<unsigned> allocations{0};
}

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* memory, std::size_t size);
void __real_free(void* memory);
void* __wrap_malloc(std::size_t size) {
  ++allocations;
  return __real_malloc(size);
}
void* __wrap_calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __real_calloc(count, size);
}
void* __wrap_realloc(void* memory, std::size_t size) {
  ++allocations;
  return __real_realloc(memory, size);
}
void __wrap_free(void* memory) {
  ++allocations;
  __real_free(memory);
}
}

void* operator new(std::size_t size) {
  void* const memory = std::malloc(size);
  if (memory == nullptr) std::abort();
  return memory;
}
void* operator new(std::size_t size, std::nothrow_t const&) noexcept {
  return std::malloc(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::nothrow_t const&) noexcept {
  std::free(memory);
}

TEST_CASE("the counter counts") {
  unsigned const before = allocations;
  int* volatile const number = new int(1);  // volatile: or the pair is optimised away
  delete number;
  unsigned const after = allocations;
  CHECK(after == before + 2);
}

namespace {

/// The levels that this processor and this build have.
std::vector<std::uint32_t> levels(Bytes const& image) {
  AlignedMemory const bytes(image);
  AlignedMemory memory(1 << 16);
  axisrt_config config{};
  config.size = sizeof config;
  config.image = bytes.data();
  config.image_size = bytes.size();
  config.cycle_time_ns = 1'000'000;
  config.memory = memory.data();
  config.memory_size = memory.size();
  std::vector<std::uint32_t> found;
  for (std::uint32_t level = AXISRT_LEVEL_AUTOMATIC; level <= AXISRT_LEVEL_NEON; ++level) {
    config.level = level;
    axisrt* runtime = nullptr;
    if (axisrt_create(&config, &runtime) == AXISRT_OK) found.push_back(level);
  }
  return found;
}

}  // namespace

TEST_CASE("no function of the runtime allocates, at any level") {
  AlignedMemory const image(write_image(complete_image()));
  AlignedMemory memory(1 << 16);
  auto const level = GENERATE_COPY(from_range(levels(write_image(complete_image()))));
  INFO("level " << level);
  axisrt_config const config{.size = sizeof(axisrt_config),
                             .cycle_time_ns = 1'000'000,
                             .image = image.data(),
                             .image_size = image.size(),
                             .memory = memory.data(),
                             .memory_size = memory.size(),
                             .level = level,
                             .reserved = 0,
                             .verify_signature = nullptr,
                             .verify_context = nullptr};
  axisrt* runtime = nullptr;
  axisrt_axis_state state{};
  double in[2] = {};
  double out[2] = {};
  std::uint8_t status[2] = {};
  std::size_t size = 0;
  AlignedMemory recorder_memory(1 << 18);
  AlignedMemory dump(1 << 18);
  axisrt_config recorder_config = config;
  recorder_config.memory = recorder_memory.data();
  recorder_config.memory_size = recorder_memory.size();
  axisrt_recorder* recorder = nullptr;
  axisrt_status dumped = AXISRT_BAD_ARGUMENT;
  double bound = 0;

  unsigned const before = allocations;
  axisrt_memory_size(&config, &size, &size);
  axisrt_create(&config, &runtime);
  axisrt_recorder_start(runtime, &recorder_config, 100, &recorder);
  for (std::uint32_t axis = 0; axis < 2; ++axis) axisrt_reset(runtime, axis, 10);
  axisrt_reset_interface(runtime, 1, 10);
  for (int i = 0; i < 1000; ++i) {
    in[0] = in[1] = i;
    axisrt_step(runtime, in, out, status);
    axisrt_step_interface(runtime, in, out, status);
    axisrt_run(runtime, in, out, 2, status);
    axisrt_get_axis_state(runtime, 0, &state);
  }
  axisrt_rebase(runtime, 0, -100);
  axisrt_axis_error_bound(runtime, 1, 1000, &bound);
  axisrt_recorder_stop(recorder);
  dumped = axisrt_recorder_dump(recorder, dump.data(), dump.size(), &size);
  unsigned const after = allocations;

  CHECK(after == before);
  CHECK(runtime != nullptr);
  CHECK(state.reset_done == 1);
  CHECK(dumped == AXISRT_OK);
  CHECK(bound > 0);
}

TEST_CASE("commands, fades and position control do not allocate, at any level") {
  AlignedMemory const image(write_image(channel_image()));
  AlignedMemory memory(1 << 16);
  auto const level = GENERATE_COPY(from_range(levels(write_image(channel_image()))));
  INFO("level " << level);
  axisrt_config const config{.size = sizeof(axisrt_config),
                             .cycle_time_ns = 1'000'000,
                             .image = image.data(),
                             .image_size = image.size(),
                             .memory = memory.data(),
                             .memory_size = memory.size(),
                             .level = level,
                             .reserved = 0,
                             .verify_signature = nullptr,
                             .verify_context = nullptr};
  axisrt* runtime = nullptr;
  double in[3] = {};
  double out[3] = {};
  double increments[3] = {};
  std::uint8_t status[3] = {};
  std::size_t length = 0;
  axisrt_velocities const velocities{
      .size = sizeof velocities, .reserved = 0, .v_set = in, .v_motor = in, .v_direct = in};
  axisrt_filter_command command{};
  command.size = sizeof command;
  unsigned accepted = 0;
  unsigned busy = 0;

  unsigned const before = allocations;
  axisrt_create(&config, &runtime);
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    axisrt_reset(runtime, axis, 10);
    axisrt_reset_velocity(runtime, axis, 10, 10, 10);
  }
  for (unsigned i = 0; i < 1000; ++i) {
    in[0] = in[1] = in[2] = i;
    command.action = i / 7 % 4;
    command.keywords = i % 3 == 0 ? AXISRT_KEYWORD_HSC : 0;
    axisrt_status const answer = axisrt_command(runtime, 0, &command);
    accepted += answer == AXISRT_OK ? 1 : 0;
    busy += answer == AXISRT_BUSY ? 1 : 0;
    axisrt_step(runtime, in, out, status);
    axisrt_step_velocity(runtime, &velocities, out, increments, status);
  }
  std::uint32_t const order = axisrt_order_of_time(runtime, 20'000);
  axisrt_group_name(runtime, 0, &length);
  unsigned const after = allocations;

  CHECK(after == before);
  CHECK(accepted > 0);
  CHECK(busy > 0);
  CHECK(order == 20);
  CHECK(length == 7);
}
