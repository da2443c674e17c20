// No cycle meets a subnormal number: the processor, which notices each, says so, whatever the inputs, the
// coefficients and the states that a recording begins with.
#include "axisrt.h"
#include "runtime/format/recording_format.h"
#include "runtime/instructions.hpp"
#include "runtime/runtime_object.hpp"
#include "support/catch.hpp"
#include "tests/runtime/control_word.hpp"
#include "tests/runtime/exact_kernel.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

using namespace axisc::test;

#if defined(AXISC_TEST_CONTROL_WORD)

namespace {

constexpr Quad T = Quad{1} / 8000;
constexpr std::uint32_t cycle_time_ns = 125'000;
constexpr std::size_t word = 8;

/// Every cycle goes past the functions that hand the caller's flags back.
class Watched {
 public:
  explicit Watched(axisrt const* runtime) : runtime_(*runtime), out_(64), status_(64) {}

  void step(double in) {
    std::vector<double> const inputs(out_.size(), in);
    for (axisc::runtime::LinePort const* port :
         {&runtime_.setpoint, &runtime_.additional_interface, &runtime_.velocity}) {
      ControlWord const callers = read_control_word();
      begin_watching_subnormals();
      runtime_.instructions->step(port->port, inputs.data(), out_.data(), status_.data());
      bool const seen = seen_subnormals();
      write_control_word(callers);
      REQUIRE_FALSE(seen);
      for (std::uint32_t i = 0; i < port->port.line_count; ++i) {
        if (status_[i] != AXISRT_NOT_RESET)
          check(out_[i]);  // that of an axis without a position is its input
      }
      for (std::uint32_t i = 0; i < port->port.batch_count; ++i) check_states(port->port.batches[i]);
    }
  }

 private:
  static void check(double value) {
    if (std::fpclassify(value) == FP_SUBNORMAL) FAIL(value);
  }
  static void check_states(axisc::runtime::Batch const& batch) {
    std::size_t const count = std::size_t{batch.group_count} * batch.state_stride;
    for (std::size_t i = 0; i < count; ++i) check(batch.states[i]);
  }

  axisrt const& runtime_;
  std::vector<double> out_;
  std::vector<std::uint8_t> status_;
};

/// Tiny and subnormal numbers, jumps, differences of one unit in the last place, and long rests in between.
void drive(axisrt const* runtime, int cycles) {
  Watched watched(runtime);
  std::mt19937_64 random(11);
  double in = 0;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    if (cycle % 700 < 60) {
      double const size = std::ldexp(1.0 + 0x1p-52 * static_cast<double>(random() >> 12U),
                                     53 - static_cast<int>(random() % 1125));
      switch (random() % 6) {
        case 0: in = 0; break;
        case 1: in = std::nextafter(in, 1e300); break;
        case 2: in = -in; break;
        default: in = random() % 2 == 0 ? size : -size;
      }
    }
    if (cycle % 700 == 60) in = 0;
    watched.step(in);
  }
}

ImageRecord image_of(std::vector<std::vector<FilterRecord>> const& chains) {
  ImageRecord image;
  image.cycle_time_ns = cycle_time_ns;
  for (std::vector<FilterRecord> const& chain : chains) {
    image.axes.emplace_back();
    image.axes.back().name = "X" + std::to_string(image.axes.size());
    image.axes.back().filters = chain;
    for (std::uint32_t i = 0; i < chain.size(); ++i) image.axes.back().filters[i].index = i;
  }
  return image;
}

FilterRecord sections(std::uint32_t count, SectionRecord const& section, bool blocks = false) {
  FilterRecord record;
  record.blocks_constant = blocks ? 1 : 0;
  record.sections.assign(count, section);
  return record;
}

std::vector<ImageRecord> images() {
  using namespace exact;
  ExactFilter const stop = bandstop_of_order_3(1, T, 10);
  ImageRecord const sound =
      image_of({{stop.record(), stop.record(), stop.record()},
                {lowpass(50, T, 1).record()},
                {highpass(30, T, 1).record(), pt2(20, T).record(), with_share(delay(5), 0.75).record()},
                {with_share(highpass(7, T, 1), 0.3).record(), with_share(bandpass(100, T, 2), 0.37).record()},
                {with_share(allpass(80, T, 1), 1e-9).record(), delay(7).record()}});
  // What verification lets pass and nobody would design: coefficients far below those of any filter.
  std::vector<std::vector<FilterRecord>> chains;
  for (double const p : {0x1.fffffffffffffp-45, 0x1.fffffffffffffp-44, 0x1.3p-1000, 0x0.8p-1022, 64.0}) {
    for (double const k : {0x1.fffffffffffffp-62, 0x1.5p-900, 0x0.1p-1022, 0x1.7p-30}) {
      FilterRecord tiny = sections(6, {.p = p, .q = -p, .k = k, .b = k});
      FilterRecord blocking = sections(6, {.p = p, .q = k, .k = k, .b = 0.5}, true);
      blocking.share = 0x1p-62;
      blocking.direct = 1;
      blocking.direct_low = -0x1.fffffffffffffp-54 * k;
      FilterRecord mixed = blocking;
      mixed.share = 1;
      mixed.direct = 0x1.fffffffffffffp-62;
      chains.push_back({tiny, tiny, tiny});
      chains.push_back({blocking, mixed, blocking});
    }
  }
  ImageRecord kernels = channel_image();
  kernels.axes[1].filters.push_back(with_share(highpass(7, T, 1), 0.3).record());
  kernels.axes[1].filters.back().index = 2;
  for (double& tail : kernels.kernels[2].tails) tail *= 0x1.7p-126;
  kernels.kernels[2].samples.clear();
  return {sound, image_of(chains), channel_image(), kernels};
}

}  // namespace

TEST_CASE("no cycle meets a subnormal number") {
  for (ImageRecord const& image : images()) {
    TestRuntime runtime(write_image(image), image.cycle_time_ns);
    REQUIRE(runtime.status == AXISRT_OK);
    for (double const position : {0.0, 0x1p-1060, 0x1.1p-499, 1e9}) {
      runtime.reset_all(position);
      for (std::uint32_t axis = 0; axis < axisrt_axis_count(runtime.runtime); ++axis) {
        axisrt_reset_interface(runtime.runtime, axis, position);
        axisrt_reset_velocity(runtime.runtime, axis, position, -position, position);
        axisrt_rebase(runtime.runtime, axis, -0x1.0000000000001p-500);
      }
      drive(runtime.runtime, 3000);
      if (axisrt_group_count(runtime.runtime) == 0) continue;
      for (std::uint32_t const order : {3U, 8U}) {
        runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER | AXISRT_KEYWORD_SHARE, order, 50);
        drive(runtime.runtime, 900);
      }
      runtime.command(AXISRT_ACTION_OFF);
      drive(runtime.runtime, 900);
    }
  }
}

namespace {

void repair(Bytes& dump) {
  poke(dump, 6 * word, 0, 8);
  poke(dump, 6 * word, naive_crc32c(dump.data() + 64, dump.size() - 64), 4);
  poke(dump, 6 * word + 4, naive_crc32c(dump.data(), 64), 4);
}

}  // namespace

TEST_CASE("no recording begins with states that would make subnormal numbers") {
  for (ImageRecord const& image : images()) {
    Bytes const bytes = write_image(image);
    AlignedMemory const in_flash(bytes);
    TestRuntime recorded(bytes, image.cycle_time_ns);
    recorded.reset_all(0);
    axisrt_config config{.size = sizeof(axisrt_config),
                         .cycle_time_ns = image.cycle_time_ns,
                         .image = in_flash.data(),
                         .image_size = in_flash.size(),
                         .memory = nullptr,
                         .memory_size = 0,
                         .level = test_level(),
                         .reserved = 0,
                         .verify_signature = nullptr,
                         .verify_context = nullptr};
    std::size_t size = 0;
    REQUIRE(axisrt_recorder_size(recorded.runtime, &config, 3, &size) == AXISRT_OK);
    AlignedMemory recorder_memory(size);
    config.memory = recorder_memory.data();
    config.memory_size = size;
    axisrt_recorder* recorder = nullptr;
    REQUIRE(axisrt_recorder_start(recorded.runtime, &config, 3, &recorder) == AXISRT_OK);
    static_cast<void>(recorded.step(0));
    Bytes dump(std::size_t{1} << 20U);
    REQUIRE(axisrt_recorder_dump(recorder, dump.data(), dump.size(), &size) == AXISRT_OK);
    dump.resize(size);
    AlignedMemory memory(recorded.memory_size);
    config.memory = memory.data();
    config.memory_size = memory.size();
    axisrt* restored = nullptr;
    auto const state = static_cast<std::size_t>(peek(dump, 3 * word, 8));
    int refused = 0;
    std::size_t const every = state / 150 + 1;
    for (std::size_t i = axrd_header_words; i < axrd_header_words + state; i += every) {
      std::uint64_t const before = peek(dump, i * word, 8);
      if (before == 0 && i % 3 == 0) continue;
      for (double const hostile :
           {0x1p-1074, 0x1.8p-1000, 0x1.8000000000001p-856, -0x1.8000000000001p-568, 0x1p256}) {
        poke(dump, i * word, std::bit_cast<std::uint64_t>(hostile), 8);
        repair(dump);
        if (axisrt_restore(&config, dump.data(), dump.size(), &restored) == AXISRT_OK) break;
        refused += 1;
        poke(dump, i * word, before, 8);
      }
    }
    CHECK(refused > 10);
    repair(dump);
    REQUIRE(axisrt_restore(&config, dump.data(), dump.size(), &restored) == AXISRT_OK);
    drive(restored, 1500);
  }
}

#endif
