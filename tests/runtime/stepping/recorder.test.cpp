// A recording begins with a state and holds what happened since: executed again, it gives the same bits.
#include "axisrt.h"
#include "runtime/format/recording_format.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

namespace recorder_test {

using namespace axisc::test;

namespace {

constexpr std::size_t word = 8;

std::uint64_t word_at(Bytes const& dump, std::size_t index) {
  return peek(dump, index * word, 8);
}

/// A runtime with a recorder.
class Recorded {
 public:
  explicit Recorded(ImageRecord const& image, std::uint32_t cycles)
      : bytes_(write_image(image)), image_(bytes_), runtime(bytes_) {
    REQUIRE(runtime.status == AXISRT_OK);
    start(cycles);
  }
  void start(std::uint32_t cycles) {
    axisrt_config config = config_of(image_);
    std::size_t size = 0;
    REQUIRE(axisrt_recorder_size(runtime.runtime, &config, cycles, &size) == AXISRT_OK);
    memory_ = std::make_unique<AlignedMemory>(size);
    config.memory = memory_->data();
    config.memory_size = size;
    REQUIRE(axisrt_recorder_start(runtime.runtime, &config, cycles, &recorder) == AXISRT_OK);
  }
  [[nodiscard]] static axisrt_config config_of(AlignedMemory const& image) {
    return {.size = sizeof(axisrt_config),
            .cycle_time_ns = 1'000'000,
            .image = image.data(),
            .image_size = image.size(),
            .memory = nullptr,
            .memory_size = 0,
            .level = test_level(),
            .reserved = 0,
            .verify_signature = nullptr,
            .verify_context = nullptr};
  }
  [[nodiscard]] Bytes dump() const {
    std::size_t size = 0;
    REQUIRE(axisrt_recorder_dump(recorder, nullptr, 0, &size) == AXISRT_MEMORY_TOO_SMALL);
    Bytes bytes(size);
    REQUIRE(axisrt_recorder_dump(recorder, bytes.data(), bytes.size(), &size) == AXISRT_OK);
    return bytes;
  }
  [[nodiscard]] AlignedMemory const& image() const { return image_; }

 private:
  Bytes bytes_;
  AlignedMemory image_;
  std::unique_ptr<AlignedMemory> memory_;

 public:
  TestRuntime runtime;
  axisrt_recorder* recorder = nullptr;
};

/// The runtime that a dump begins with.
struct Restored {
  Restored(AlignedMemory const& image, Bytes const& dump) {
    axisrt_config config = Recorded::config_of(image);
    config.level = static_cast<std::uint32_t>(word_at(dump, 1));
    std::size_t size = 0;
    std::size_t alignment = 0;
    REQUIRE(axisrt_memory_size(&config, &size, &alignment) == AXISRT_OK);
    memory = std::make_unique<AlignedMemory>(size);
    config.memory = memory->data();
    config.memory_size = size;
    config.level = AXISRT_LEVEL_PORTABLE;  // that of the dump wins
    status = axisrt_restore(&config, dump.data(), dump.size(), &runtime);
  }
  std::unique_ptr<AlignedMemory> memory;
  axisrt* runtime = nullptr;
  axisrt_status status = AXISRT_OK;
};

double number(std::uint64_t bits) {
  return std::bit_cast<double>(bits);
}

std::vector<double> numbers(Bytes const& dump, std::size_t first, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(number(word_at(dump, first + i)));
  return values;
}

bool same_bits(std::vector<double> const& a, std::vector<double> const& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

struct Replayed {
  std::uint64_t entries = 0;
  std::uint64_t cycles = 0;
  std::uint64_t commands = 0;
  std::uint64_t differences = 0;
};

/// Executes the entries of a dump with a reader of its own.
Replayed replay(AlignedMemory const& image, Bytes const& dump) {
  Restored restored(image, dump);
  REQUIRE(restored.status == AXISRT_OK);
  Replayed result;
  std::size_t const n = axisrt_axis_count(restored.runtime);
  std::size_t const status_words = (n + 7) / 8;
  std::size_t at = axrd_header_words + static_cast<std::size_t>(word_at(dump, 3));
  std::size_t const end = at + static_cast<std::size_t>(word_at(dump, 4));
  REQUIRE(end * word == dump.size());
  while (at < end) {
    std::uint64_t const head = word_at(dump, at++);
    auto const index = static_cast<std::uint32_t>(head >> 32U);
    auto const expected = static_cast<axisrt_status>(head >> 16U & 0xFFFFU);
    std::uint64_t const flags = head >> 8U & 0xFFU;
    std::vector<std::uint8_t> status(status_words * word, 0);
    axisrt_status happened = AXISRT_OK;
    result.entries += 1;
    switch (head & 0xFFU) {
      case axrd_step:
      case axrd_step_interface: {
        std::vector<double> const in = numbers(dump, at, n);
        std::vector<double> out(n);
        auto* const step = (head & 0xFFU) == axrd_step ? axisrt_step : axisrt_step_interface;
        happened = step(restored.runtime, in.data(), out.data(), status.data());
        result.differences += same_bits(out, numbers(dump, at + n, n)) ? 0 : 1;
        if ((flags & axrd_has_status) != 0) {
          result.differences += std::memcmp(status.data(), dump.data() + (at + 2 * n) * word, n) == 0 ? 0 : 1;
        }
        result.cycles += (head & 0xFFU) == axrd_step ? 1 : 0;
        at += 2 * n + status_words;
        break;
      }
      case axrd_step_velocity: {
        std::vector<double> const in = numbers(dump, at, 3 * n);
        axisrt_velocities velocities{};
        velocities.size = sizeof velocities;
        velocities.v_set = in.data();
        velocities.v_motor = in.data() + n;
        if ((flags & axrd_has_v_direct) != 0) velocities.v_direct = in.data() + 2 * n;
        std::vector<double> out(2 * n);
        double* const increments = (flags & axrd_has_increments) != 0 ? out.data() + n : nullptr;
        happened = axisrt_step_velocity(restored.runtime, &velocities, out.data(), increments, status.data());
        result.differences += same_bits(out, numbers(dump, at + 3 * n, 2 * n)) ? 0 : 1;
        at += 5 * n + status_words;
        break;
      }
      case axrd_reset: happened = axisrt_reset(restored.runtime, index, number(word_at(dump, at++))); break;
      case axrd_reset_interface:
        happened = axisrt_reset_interface(restored.runtime, index, number(word_at(dump, at++)));
        break;
      case axrd_reset_velocity: {
        std::vector<double> const v = numbers(dump, at, 3);
        happened = axisrt_reset_velocity(restored.runtime, index, v[0], v[1], v[2]);
        at += 3;
        break;
      }
      case axrd_rebase: happened = axisrt_rebase(restored.runtime, index, number(word_at(dump, at++))); break;
      case axrd_command: {
        axisrt_filter_command command{};
        command.size = sizeof command;
        command.action = static_cast<std::uint32_t>(word_at(dump, at));
        command.keywords = static_cast<std::uint32_t>(word_at(dump, at) >> 32U);
        command.order = static_cast<std::uint32_t>(word_at(dump, at + 1));
        command.share = number(word_at(dump, at + 2));
        command.fcut = number(word_at(dump, at + 3));
        command.quality = number(word_at(dump, at + 4));
        happened = axisrt_command(restored.runtime, index, &command);
        result.commands += 1;
        at += axrd_command_words;
        break;
      }
      default: FAIL("an entry of unknown kind");
    }
    result.differences += happened == expected ? 0 : 1;
  }
  CHECK(result.entries == word_at(dump, 5));
  return result;
}

/// Everything that a controller may do, at random.
class Controller {
 public:
  explicit Controller(unsigned seed) : random_(seed) {}
  void cycle(TestRuntime& runtime) {
    std::uint32_t const n = axisrt_axis_count(runtime.runtime);
    in_.resize(n);
    for (double& x : in_) x += static_cast<double>(random_() % 2001) - 1000;
    between(runtime, n);
    std::vector<double> in = in_;
    if (one_in(50)) in[random_() % n] = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> out(n);
    std::vector<std::uint8_t> status(n);
    axisrt_step(runtime.runtime, in.data(), one_in(3) ? in.data() : out.data(),
                one_in(2) ? status.data() : nullptr);
    axisrt_step_interface(runtime.runtime, in_.data(), out.data(), nullptr);
    axisrt_velocities velocities{};
    velocities.size = sizeof velocities;
    velocities.v_set = velocities.v_motor = in_.data();
    if (one_in(2)) velocities.v_direct = in_.data();
    std::vector<double> increments(n);
    axisrt_step_velocity(runtime.runtime, &velocities, out.data(), one_in(2) ? increments.data() : nullptr,
                         status.data());
  }

 private:
  bool one_in(unsigned n) { return random_() % n == 0; }
  void between(TestRuntime& runtime, std::uint32_t n) {
    if (one_in(20)) {
      static_cast<void>(runtime.command(static_cast<axisrt_action>(random_() % 4),
                                        static_cast<std::uint32_t>(random_() % 32), 3, 50));
    }
    auto const axis = static_cast<std::uint32_t>(random_() % n);
    if (one_in(100)) axisrt_reset(runtime.runtime, axis, in_[axis]);
    if (one_in(100)) axisrt_reset_interface(runtime.runtime, axis, in_[axis]);
    if (one_in(100)) axisrt_reset_velocity(runtime.runtime, axis, in_[axis], 5, -5);
    if (one_in(100) && axisrt_rebase(runtime.runtime, axis, 4096) == AXISRT_OK) in_[axis] += 4096;
  }
  std::mt19937 random_;
  std::vector<double> in_;
};

/// Five times the axes of another image, so that groups of every width occur.
ImageRecord repeated(ImageRecord const& image) {
  ImageRecord many;
  for (int i = 0; i < 5; ++i) {
    for (AxisRecord axis : image.axes) {
      axis.name += std::to_string(i);
      axis.number = static_cast<std::uint32_t>(many.axes.size() + 1);
      many.axes.push_back(axis);
    }
  }
  return many;
}

/// Eight axes with a low-pass each.
Bytes eight_axes() {
  ImageRecord image;
  image.strip = true;
  for (std::uint32_t i = 0; i < 8; ++i) {
    AxisRecord axis;
    axis.number = i + 1;
    axis.filters = {exact::lowpass(20 + static_cast<int>(i), Quad{1} / 1000, 1).record()};
    image.axes.push_back(axis);
  }
  return write_image(image);
}

/// An image with the bytes of another behind its section table, which says that there is one axis with one
/// filter.
Bytes first_axis_of(Bytes image) {
  for (std::uint32_t const kind : {axes_kind, filters_kind}) {
    std::size_t const entry = entry_offset(image, kind);
    poke(image, entry + 16, peek(image, entry + 24, 4), 8);
    poke(image, entry + 28, 1, 4);
  }
  poke(image, 36, 1, 4);
  repair_checksums(image);
  return image;
}

/// Chooses 32 bits of the header that mean nothing to a runtime such that its checksum is `wanted`. A CRC of
/// bits that are flipped one by one is linear: they are found by elimination.
void force_header_checksum(Bytes& image, std::uint32_t wanted) {
  constexpr std::size_t source_digest = 48;
  auto const with_flipped = [&](std::uint64_t bits) {
    Bytes flipped = image;
    poke(flipped, source_digest, peek(image, source_digest, 4) ^ bits, 4);
    repair_checksums(flipped);
    return flipped;
  };
  auto const checksum_of = [](Bytes const& bytes) { return peek(bytes, 12, 4); };
  std::uint64_t const plain = checksum_of(image);
  struct Flip {
    std::uint64_t effect, bits;
  };
  std::vector<Flip> basis;
  auto const reduce = [&](Flip flip) {
    for (Flip const& one : basis) {
      if ((flip.effect ^ one.effect) < flip.effect) flip = {flip.effect ^ one.effect, flip.bits ^ one.bits};
    }
    return flip;
  };
  for (std::uint32_t bit = 0; bit < 32; ++bit) {
    std::uint64_t const bits = std::uint64_t{1} << bit;
    basis.push_back(reduce({checksum_of(with_flipped(bits)) ^ plain, bits}));
    std::sort(basis.begin(), basis.end(), [](Flip const& a, Flip const& b) { return a.effect > b.effect; });
  }
  image = with_flipped(reduce({plain ^ wanted, 0}).bits);
  REQUIRE(checksum_of(image) == wanted);
}

/// What recorder_start answers for a runtime of `image`, given `other`.
axisrt_status start_with(Bytes const& image, Bytes const& other) {
  TestRuntime runtime(image);
  REQUIRE(runtime.status == AXISRT_OK);
  runtime.reset_all(1);
  AlignedMemory const other_image(other);
  axisrt_config config = Recorded::config_of(other_image);
  std::size_t size = 0;
  REQUIRE(axisrt_recorder_size(runtime.runtime, &config, 1, &size) == AXISRT_OK);
  AlignedMemory memory(size);
  config.memory = memory.data();
  config.memory_size = memory.size();
  axisrt_recorder* recorder = nullptr;
  axisrt_status const status = axisrt_recorder_start(runtime.runtime, &config, 1, &recorder);
  CHECK((recorder != nullptr) == (status == AXISRT_OK));
  for (int cycle = 0; cycle < 10; ++cycle) static_cast<void>(runtime.step(cycle));
  axisrt_recorder_stop(recorder);
  return status;
}

}  // namespace

TEST_CASE("an image with the same sections in another table is not the one that is recorded") {
  Bytes const image = eight_axes();
  CHECK(start_with(image, image) == AXISRT_OK);
  Bytes other = first_axis_of(image);
  REQUIRE(peek(other, 24, 4) == peek(image, 24, 4));  // the checksum of everything behind the table
  CHECK(start_with(image, other) == AXISRT_OTHER_IMAGE);
  CHECK(start_with(other, image) == AXISRT_OTHER_IMAGE);
  force_header_checksum(other, static_cast<std::uint32_t>(peek(image, 12, 4)));
  CHECK(start_with(image, other) == AXISRT_OTHER_IMAGE);
  CHECK(start_with(other, image) == AXISRT_OTHER_IMAGE);
}

TEST_CASE("a recording replays bit for bit, before and after the ring is full") {
  for (ImageRecord const& image : {channel_image(), complete_image(), repeated(complete_image())}) {
    Recorded recorded(image, 40);
    Controller controller(7);
    std::uint64_t commands = 0;
    for (int cycle = 1; cycle <= 2000; ++cycle) {
      controller.cycle(recorded.runtime);
      if (cycle % 97 != 0 && cycle > 5) continue;
      Replayed const replayed = replay(recorded.image(), recorded.dump());
      REQUIRE(replayed.differences == 0);
      REQUIRE(replayed.cycles >= static_cast<std::uint64_t>(cycle < 40 ? cycle : 39));
      commands += replayed.commands;
    }
    if (!image.groups.empty()) CHECK(commands > 0);
  }
}

TEST_CASE("a recorder may start in the middle of a motion and of a fade") {
  Recorded recorded(channel_image(), 10);
  axisrt_recorder_stop(recorded.recorder);
  recorded.runtime.reset_all(0);
  for (int i = 0; i < 35; ++i) static_cast<void>(recorded.runtime.step_all({30.0 * i, -20.0 * i, 0}));
  REQUIRE(recorded.runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
  for (int i = 35; i < 50; ++i) static_cast<void>(recorded.runtime.step_all({30.0 * i, -20.0 * i, 0}));
  REQUIRE(recorded.runtime.state(0).fading == 1);
  recorded.start(100);
  for (int i = 50; i < 150; ++i) static_cast<void>(recorded.runtime.step_all({30.0 * i, -20.0 * i, 0}));
  Replayed const replayed = replay(recorded.image(), recorded.dump());
  CHECK(replayed.differences == 0);
  CHECK(replayed.cycles == 100);
}

TEST_CASE("what was recorded is restored, however slow the axes' limits are") {
  for (double const velocity_limit : {1e-300, 1e-295, 1e-180, 4e-307, 0.0, 1e300}) {
    CAPTURE(velocity_limit);
    ImageRecord image = channel_image();
    for (AxisRecord& axis : image.axes) axis.velocity_limit = velocity_limit;
    Recorded recorded(image, 5);
    recorded.runtime.reset_all(0);
    for (int i = 0; i < 20; ++i) static_cast<void>(recorded.runtime.step_all({30.0 * i, -20.0 * i, 0}));
    CHECK(Restored(recorded.image(), recorded.dump()).status == AXISRT_OK);
  }
}

TEST_CASE("recording changes no output") {
  Recorded recorded(channel_image(), 5);
  TestRuntime plain(write_image(channel_image()));
  recorded.runtime.reset_all(1e9);
  plain.reset_all(1e9);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> const in = {1e9 + 30.0 * i, 1e9 - 20.0 * i, 1e9};
    REQUIRE(recorded.runtime.step_all(in) == plain.step_all(in));
  }
}

TEST_CASE("a changed bit is noticed: in the dump by its checksum, in an output by the replay") {
  Recorded recorded(channel_image(), 20);
  Controller controller(3);
  for (int i = 0; i < 30; ++i) controller.cycle(recorded.runtime);
  Bytes const dump = recorded.dump();
  for (std::size_t bit = 0; bit < dump.size() * 8; bit += 37) {
    Bytes damaged = dump;
    damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ 1U << bit % 8);
    axisrt* runtime = nullptr;
    axisrt_config const config = Recorded::config_of(recorded.image());
    REQUIRE(axisrt_restore(&config, damaged.data(), damaged.size(), &runtime) == AXISRT_BAD_RECORDING);
    REQUIRE(runtime == nullptr);
  }
}

TEST_CASE("a stopped recorder keeps what it has, and another may start") {
  Recorded recorded(channel_image(), 10);
  Controller controller(5);
  for (int i = 0; i < 30; ++i) controller.cycle(recorded.runtime);
  axisrt_recorder_stop(recorded.recorder);
  Bytes const dump = recorded.dump();
  for (int i = 0; i < 30; ++i) controller.cycle(recorded.runtime);
  CHECK(recorded.dump() == dump);
  axisrt_recorder_stop(recorded.recorder);
  axisrt_recorder_stop(nullptr);
  recorded.start(10);
  for (int i = 0; i < 30; ++i) controller.cycle(recorded.runtime);
  CHECK(replay(recorded.image(), recorded.dump()).differences == 0);
}

TEST_CASE("a recorder has the cycle time and the level of its runtime, whatever its configuration says") {
  Recorded recorded(channel_image(), 10);
  axisrt_recorder_stop(recorded.recorder);
  axisrt_config config = Recorded::config_of(recorded.image());
  config.cycle_time_ns = 7;
  config.level = 99;
  std::size_t size = 0;
  REQUIRE(axisrt_recorder_size(recorded.runtime.runtime, &config, 10, &size) == AXISRT_OK);
  AlignedMemory memory(size);
  config.memory = memory.data();
  config.memory_size = memory.size();
  REQUIRE(axisrt_recorder_start(recorded.runtime.runtime, &config, 10, &recorded.recorder) == AXISRT_OK);
  Controller controller(6);
  for (int i = 0; i < 30; ++i) controller.cycle(recorded.runtime);
  CHECK(replay(recorded.image(), recorded.dump()).differences == 0);
}

TEST_CASE("a runtime is recorded while another is prepared, and that one once its change is over") {
  ImageRecord plain;
  plain.axes.resize(2);
  Recorded recorded(plain, 10);
  axisrt_recorder_stop(recorded.recorder);
  axisrt* const active = recorded.runtime.runtime;
  for (std::uint32_t axis = 0; axis < 2; ++axis) REQUIRE(axisrt_reset(active, axis, 5) == AXISRT_OK);
  axisrt_config config = Recorded::config_of(recorded.image());
  std::size_t size = 0;
  std::size_t alignment = 0;
  REQUIRE(axisrt_memory_size(&config, &size, &alignment) == AXISRT_OK);
  AlignedMemory of_prepared(size);
  config.memory = of_prepared.data();
  config.memory_size = of_prepared.size();
  axisrt* prepared = nullptr;
  REQUIRE(axisrt_prepare(active, &config, 0, &prepared) == AXISRT_OK);

  recorded.start(10);
  AlignedMemory of_another(1 << 16);
  config.memory = of_another.data();
  config.memory_size = of_another.size();
  axisrt_recorder* another = nullptr;
  CHECK(axisrt_recorder_start(prepared, &config, 10, &another) == AXISRT_BUSY);
  std::vector<double> const in(2, 5);
  std::vector<double> out(2);
  for (int cycle = 0; cycle < 100; ++cycle) {
    REQUIRE(axisrt_step(active, in.data(), out.data(), nullptr) == AXISRT_OK);
    REQUIRE(axisrt_shadow_step(prepared) == AXISRT_OK);
  }
  Bytes const before = recorded.dump();
  CHECK(replay(recorded.image(), before).differences == 0);

  REQUIRE(axisrt_swap(prepared) == AXISRT_OK);
  CHECK(axisrt_recorder_start(prepared, &config, 10, &another) == AXISRT_BUSY);
  while (axisrt_swap_done(prepared) == 0) {
    REQUIRE(axisrt_step(prepared, in.data(), out.data(), nullptr) == AXISRT_OK);
  }
  CHECK(recorded.dump() == before);  // the change has ended the recording
  CHECK(axisrt_recorder_start(prepared, &config, 10, &another) == AXISRT_OK);
}

TEST_CASE("what cannot be recorded or restored is refused") {
  Recorded recorded(channel_image(), 10);
  axisrt_config config = Recorded::config_of(recorded.image());
  axisrt_recorder* other = nullptr;
  AlignedMemory memory(1 << 20);
  config.memory = memory.data();
  config.memory_size = memory.size();
  CHECK(axisrt_recorder_start(recorded.runtime.runtime, &config, 10, &other) == AXISRT_BUSY);
  Bytes const dump = recorded.dump();
  axisrt_recorder_stop(recorded.recorder);

  ImageRecord changed = channel_image();
  changed.axes[0].position_window = 0.5;
  AlignedMemory const changed_image(write_image(changed));
  axisrt_config wrong = config;
  wrong.image = changed_image.data();
  wrong.image_size = changed_image.size();
  CHECK(axisrt_recorder_start(recorded.runtime.runtime, &wrong, 10, &other) == AXISRT_OTHER_IMAGE);
  CHECK(other == nullptr);
  axisrt* runtime = nullptr;
  CHECK(axisrt_restore(&wrong, dump.data(), dump.size(), &runtime) == AXISRT_OTHER_IMAGE);
  CHECK(runtime == nullptr);

  config.memory_size = 64;
  CHECK(axisrt_recorder_start(recorded.runtime.runtime, &config, 10, &other) == AXISRT_MEMORY_TOO_SMALL);
  CHECK(axisrt_restore(&config, dump.data(), dump.size(), &runtime) == AXISRT_MEMORY_TOO_SMALL);
  config.memory = nullptr;
  CHECK(axisrt_recorder_start(recorded.runtime.runtime, &config, 10, &other) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_recorder_start(nullptr, &config, 10, &other) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_restore(&config, nullptr, 0, &runtime) == AXISRT_BAD_ARGUMENT);
  for (std::size_t const size : {std::size_t{0}, std::size_t{63}, std::size_t{64}, dump.size() - 8}) {
    CHECK(axisrt_restore(&config, dump.data(), size, &runtime) == AXISRT_BAD_RECORDING);
  }
}

namespace {

/// Computes both checksums anew.
void repair_dump(Bytes& dump) {
  poke(dump, 6 * word, 0, 8);
  poke(dump, 6 * word, naive_crc32c(dump.data() + 64, dump.size() - 64), 4);
  poke(dump, 6 * word + 4, naive_crc32c(dump.data(), 64), 4);
}

}  // namespace

TEST_CASE("numbers of a dump that lead outside the memory are refused, with a right checksum too") {
  Recorded recorded(channel_image(), 5);
  recorded.runtime.reset_all(0);
  for (int i = 0; i < 20; ++i) static_cast<void>(recorded.runtime.step_all({30.0 * i, -20.0 * i, 0}));
  Bytes const dump = recorded.dump();
  auto const state = static_cast<std::size_t>(word_at(dump, 3));
  int refused = 0;
  for (std::size_t i = 0; i < state; ++i) {
    Bytes damaged = dump;
    poke(damaged, (axrd_header_words + i) * word, 0xFFFFFFFF, 8);
    repair_dump(damaged);
    Restored restored(recorded.image(), damaged);
    if (restored.status != AXISRT_OK) {
      REQUIRE(restored.status == AXISRT_BAD_RECORDING);
      refused += 1;
      continue;
    }
    for (int cycle = 0; cycle < 40; ++cycle) {  // only numbers were changed: the sanitizers see no bad access
      double in[3] = {1, 2, 3};
      axisrt_step(restored.runtime, in, in, nullptr);
    }
  }
  CHECK(refused > 10);
}

TEST_CASE("states that no cycle leaves behind are refused") {
  Recorded recorded(channel_image(), 5);
  recorded.runtime.reset_all(0);
  for (int i = 0; i < 60; ++i) static_cast<void>(recorded.runtime.step_all({30.0 * i, -20.0 * i, 0}));
  Bytes const dump = recorded.dump();
  auto const state = static_cast<std::size_t>(word_at(dump, 3));
  std::uint64_t const whole_mask = ~std::uint64_t{0};
  int masks = 0;
  for (std::size_t i = axrd_header_words; i < axrd_header_words + state; ++i) {
    masks += word_at(dump, i) == whole_mask ? 1 : 0;
    // A part of a mask, a NaN, an infinity, more than a state can be, and a mask that is taken away or added.
    for (std::uint64_t const bits :
         {std::uint64_t{0xFFFF'FFFF'FFFF'FF00}, std::uint64_t{1}, std::uint64_t{0x7FF8'0000'0000'0001},
          std::uint64_t{0x7FF0'0000'0000'0000}, std::uint64_t{0x7FEF'FFFF'FFFF'FFFF},
          std::uint64_t{0x8000'0000'0000'0000}, std::uint64_t{0}, whole_mask}) {
      Bytes damaged = dump;
      poke(damaged, i * word, bits, 8);
      repair_dump(damaged);
      Restored restored(recorded.image(), damaged);
      if (word_at(dump, i) == whole_mask && bits != whole_mask) {
        REQUIRE(restored.status == AXISRT_BAD_RECORDING);
      }
      if (restored.status != AXISRT_OK) continue;
      for (int cycle = 0; cycle < 40; ++cycle) {
        double const in[3] = {1, 2, 3};
        double out[3] = {};
        std::uint8_t status[3] = {};
        axisrt_step(restored.runtime, in, out, status);
        for (int axis = 0; axis < 3; ++axis) {
          REQUIRE(std::isfinite(out[axis]));
          bool const known = status[axis] == AXISRT_OK || status[axis] == AXISRT_IMPLAUSIBLE;
          INFO("word " << i << ", status " << int{status[axis]});
          REQUIRE(known);
        }
      }
    }
  }
  CHECK(masks >= 3);
}

TEST_CASE(
    "a recorder's memory overlaps neither its image nor its runtime, that of a restored runtime no "
    "recording") {
  Bytes const bytes = write_image(channel_image());
  // One block for all of them: runtime, image, recorder.
  AlignedMemory all(1 << 18);
  std::uint8_t* const image = all.data() + (1 << 16);
  std::copy(bytes.begin(), bytes.end(), image);
  AlignedMemory const elsewhere(bytes);
  axisrt_config config = Recorded::config_of(elsewhere);
  config.image = image;
  config.memory = all.data();
  config.memory_size = 1 << 16;
  axisrt* runtime = nullptr;
  REQUIRE(axisrt_create(&config, &runtime) == AXISRT_OK);
  axisrt_recorder* recorder = nullptr;
  for (std::size_t const offset : {0U, 1U << 10U, (1U << 16U) - 64U, 1U << 16U, (1U << 16U) + 64U}) {
    config.memory = all.data() + offset;
    config.memory_size = all.size() - offset;
    INFO(offset);
    CHECK(axisrt_recorder_start(runtime, &config, 100, &recorder) == AXISRT_BAD_ARGUMENT);
    CHECK(recorder == nullptr);
  }
  CHECK(std::equal(bytes.begin(), bytes.end(), image));
  config.memory = image + (bytes.size() + 63) / 64 * 64;
  REQUIRE(axisrt_recorder_start(runtime, &config, 100, &recorder) == AXISRT_OK);
  AlignedMemory dump(1 << 17);
  std::size_t size = 0;
  REQUIRE(axisrt_recorder_dump(recorder, dump.data(), dump.size(), &size) == AXISRT_OK);
  axisrt_recorder_stop(recorder);
  config.memory = dump.data();
  config.memory_size = dump.size();
  axisrt* restored = nullptr;
  CHECK(axisrt_restore(&config, dump.data(), size, &restored) == AXISRT_BAD_ARGUMENT);
  CHECK(restored == nullptr);
}

}  // namespace recorder_test
