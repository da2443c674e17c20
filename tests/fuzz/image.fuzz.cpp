// Any bytes as an image whose magic, version, size and checksums are right, so that the checks behind them
// are reached: verify answers with a status and reads nothing outside, and whatever it accepts is created and
// executed.
#include "axisrt.h"
#include "runtime/format/crc32c.hpp"
#include "tests/runtime/aligned_memory.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using axisc::test::AlignedMemory;

constexpr std::size_t header_size = 128;
constexpr std::size_t entry_size = 32;

std::uint64_t load(std::uint8_t const* from, int size) {
  std::uint64_t value = 0;
  for (int i = size - 1; i >= 0; --i) value = value << 8U | from[i];
  return value;
}

void store(std::uint8_t* to, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) to[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

/// Magic, version, total size and checksums, as far as the header can be followed.
void repair(std::uint8_t* image, std::size_t size) {
  if (size < header_size) return;
  std::memcpy(image, "AXIM", 4);
  store(image + 4, 1, 2);
  store(image + 16, size, 8);
  std::uint64_t const directory_end = load(image + 8, 4) + load(image + 28, 4) * entry_size;
  if (directory_end > size) return;
  auto const payload = static_cast<std::size_t>(directory_end);
  store(image + 24, axim_crc32c(image + payload, size - payload), 4);
  store(image + 12, 0, 4);
  store(image + 12, axim_crc32c(image, payload), 4);
}

void require(bool condition) {
  if (!condition) std::abort();
}

void step_all(axisrt* runtime, double in) {
  std::uint32_t const axes = axisrt_axis_count(runtime);
  std::vector<double> const inputs(axes, in);
  std::vector<double> outputs(axes);
  std::vector<std::uint8_t> status(axes);
  axisrt_step(runtime, inputs.data(), outputs.data(), status.data());
  for (double const out : outputs) require(std::isfinite(out));
  axisrt_step_interface(runtime, inputs.data(), outputs.data(), status.data());
  for (double const out : outputs) require(std::isfinite(out));
}

/// Velocities of all axes; the additive ones stay finite.
void step_velocity(axisrt* runtime, double in) {
  std::uint32_t const axes = axisrt_axis_count(runtime);
  std::vector<double> const inputs(axes, in);
  std::vector<double> v_add(axes);
  std::vector<double> increments(axes);
  std::vector<std::uint8_t> status(axes);
  axisrt_velocities velocities{};
  velocities.size = sizeof velocities;
  velocities.v_set = velocities.v_motor = inputs.data();
  axisrt_step_velocity(runtime, &velocities, v_add.data(), increments.data(), status.data());
  for (double const v : v_add) require(std::isfinite(v));
  for (double const increment : increments) require(std::isfinite(increment));
}

/// Every action on every group, with the parameters of sound images and others.
void command_all(axisrt* runtime, std::uint32_t round) {
  for (std::uint32_t group = 0; group < axisrt_group_count(runtime); ++group) {
    axisrt_filter_command command{};
    command.size = sizeof command;
    command.action = (round + group) % 4;
    constexpr std::uint32_t keywords[] = {0, AXISRT_KEYWORD_HSC, AXISRT_KEYWORD_ORDER,
                                          AXISRT_KEYWORD_ORDER | AXISRT_KEYWORD_SHARE};
    command.keywords = keywords[round / 4 % std::size(keywords)];
    command.order = command.keywords == AXISRT_KEYWORD_ORDER ? 8 : 3;
    command.share = 50;
    axisrt_status const status = axisrt_command(runtime, group, &command);
    require(status == AXISRT_OK || status == AXISRT_BUSY || status == AXISRT_NO_BANK ||
            status == AXISRT_NEEDS_STANDSTILL);
    std::size_t length = 0;
    char const* const name = axisrt_group_name(runtime, group, &length);
    unsigned sum = 0;
    for (std::size_t i = 0; i < length; ++i) sum += static_cast<unsigned char>(name[i]);
    require(sum <= 255 * length);
  }
}

void run(axisrt* runtime) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::uint32_t const axes = axisrt_axis_count(runtime);
  step_all(runtime, 1e308);
  step_velocity(runtime, 1e308);
  command_all(runtime, 1);
  for (std::uint32_t axis = 0; axis < axes; ++axis) {
    std::size_t length = 0;
    char const* const name = axisrt_axis_name(runtime, axis, &length);
    unsigned sum = 0;
    for (std::size_t i = 0; i < length; ++i) sum += static_cast<unsigned char>(name[i]);
    require(sum <= 255 * length);
    require(axisrt_reset(runtime, axis, 1e9) == AXISRT_OK);
    require(axisrt_reset_interface(runtime, axis, -0x1p53) == AXISRT_OK);
    require(axisrt_reset_velocity(runtime, axis, 0x1p53, -0x1p53, 0) == AXISRT_OK);
  }
  std::uint32_t commands = 0;
  for (int round = 0; round < 5; ++round) {
    for (double const in : {0x1p53, -0x1p53, infinity, 1e9, 0.0, 5e-324}) {
      step_all(runtime, in);
      step_velocity(runtime, in);
      command_all(runtime, commands++);
    }
    for (std::uint32_t axis = 0; axis < axes; ++axis) {
      axisrt_axis_state state{};
      axisrt_rebase(runtime, axis, 3'600'000);
      require(axisrt_get_axis_state(runtime, axis, &state) == AXISRT_OK);
      require(std::isfinite(state.filtered) && state.filters <= AXISRT_MOST_FILTERS);
    }
  }
}

/// Numbers at the edges of what the format allows.
std::uint64_t edge_value(std::minstd_rand& random) {
  constexpr double doubles[] = {0.0,
                                1.0,
                                2.0,
                                4.0,
                                64.0,
                                -64.0,
                                0x1p-1000,
                                0x1p53,
                                0x1p1023,
                                -0x1p-53,
                                2 - 0x1p-52,
                                std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity()};
  constexpr std::uint64_t integers[] = {0,
                                        1,
                                        2,
                                        3,
                                        4,
                                        6,
                                        7,
                                        63,
                                        64,
                                        100,
                                        101,
                                        200,
                                        201,
                                        1024,
                                        4096,
                                        4097,
                                        0xFFFFFFFF,
                                        0x7FFFFFFF,
                                        0xFFFFFFFFFFFFFFC0};
  if (random() % 2 == 0) return std::bit_cast<std::uint64_t>(doubles[random() % std::size(doubles)]);
  return integers[random() % std::size(integers)];
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  std::minstd_rand random(seed);
  if (size < header_size || random() % 2 == 0) {
    size = LLVMFuzzerMutate(data, size, max_size);
  } else {
    int const width = random() % 2 == 0 ? 4 : 8;
    std::size_t const place = random() % (size / 8) * 8;
    store(data + place, edge_value(random), width);
  }
  repair(data, size);
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  AlignedMemory image(std::span(data, size));
  static_cast<void>(axisrt_verify(image.data(), image.size()));
  repair(image.data(), image.size());
  if (axisrt_verify(image.data(), image.size()) != AXISRT_OK) return 0;

  axisrt_config config{.size = sizeof(axisrt_config),
                       .cycle_time_ns = static_cast<std::uint32_t>(load(image.data() + 32, 4)),
                       .image = image.data(),
                       .image_size = image.size(),
                       .memory = nullptr,
                       .memory_size = 0,
                       .level = AXISRT_LEVEL_AUTOMATIC,
                       .reserved = 0,
                       .verify_signature = nullptr,
                       .verify_context = nullptr};
  std::size_t alignment = 0;
  require(axisrt_memory_size(&config, &config.memory_size, &alignment) == AXISRT_OK);
  AlignedMemory memory(config.memory_size);
  config.memory = memory.data();
  axisrt* runtime = nullptr;
  axisrt_status const status = axisrt_create(&config, &runtime);
  require(status == AXISRT_OK || status == AXISRT_SELF_TEST_FAILED);
  if (status == AXISRT_OK) run(runtime);
  return 0;
}
