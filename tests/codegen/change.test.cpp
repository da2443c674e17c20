// Change of image in motion: the bounds that axisrt.h states, what is refused, and that nothing is lost.
#include "axisrt.h"
#include "codegen/aligned_bytes.hpp"
#include "codegen/fade.hpp"
#include "codegen/image_writer.hpp"
#include "support/catch.hpp"
#include "tests/codegen/machines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace change_test {

using namespace axisc;
using codegen::AlignedBytes;
using design::FilterSpecification;
using design::FilterType;
using design::KernelType;

namespace {

constexpr design::CycleTime cycle_time{1'000'000};
constexpr std::size_t axes = 3;

/// Three axes; the variants differ in every filter.
machine::Machine machine_variant(int variant) {
  machine::Machine machine;
  machine.cycle_time = cycle_time;
  machine.axes.resize(axes);
  double const f = variant == 0 ? 40 : 55;
  for (std::size_t i = 0; i < axes; ++i) {
    machine.axes[i].name = std::string(1, static_cast<char>('X' + i));
    machine.axes[i].number = static_cast<std::uint32_t>(i + 1);
    machine.axes[i].velocity_limit = 500'000;
    machine.axes[i].acceleration_limit = 8000;
  }
  machine.groups = {{.name = "channel", .axes = {0, 1, 2}, .filter_sets = {}}};
  machine.axes[0].filters = {{.index = 0,
                              .specification = {.type = FilterType::bandstop,
                                                .prototype = design::Prototype::butterworth,
                                                .order = 2,
                                                .frequency = {f},
                                                .quality = 2}}};
  machine.axes[1].filters = {
      {.index = 0, .specification = {.type = FilterType::lowpass, .order = 2, .frequency = {2 * f}}}};
  machine.axes[1].kernel =
      test::fir({.type = KernelType::moving_average, .order = variant == 0 ? 20U : 50U}, true);
  machine.axes[2].kernel =
      test::fir({.type = variant == 0 ? KernelType::gaussian : KernelType::time_delay, .order = 40}, true);
  return machine;
}

/// A runtime with its memory.
class Made {
 public:
  Made(machine::Machine const& machine, std::uint32_t image_version, axisrt* active = nullptr,
       std::uint32_t options = 0)
      : Made(codegen::write_image(machine, {.strip = false, .image_version = image_version}), active,
             options) {}
  explicit Made(std::vector<std::byte> const& image, axisrt* active = nullptr, std::uint32_t options = 0)
      : image_(image) {
    axisrt_config config{};
    config.size = sizeof config;
    config.cycle_time_ns = cycle_time.nanoseconds;
    config.image = image_.data();
    config.image_size = image_.size();
    std::size_t size = 0;
    std::size_t alignment = 0;
    REQUIRE(axisrt_memory_size(&config, &size, &alignment) == AXISRT_OK);
    memory_.emplace(size);
    config.memory = memory_->data();
    config.memory_size = memory_->size();
    status = active == nullptr ? axisrt_create(&config, &runtime)
                               : axisrt_prepare(active, &config, options, &runtime);
  }

  axisrt* runtime = nullptr;
  axisrt_status status = AXISRT_OK;

 private:
  AlignedBytes image_;
  std::optional<AlignedBytes> memory_;
};

/// Setpoints within the limits, with stops.
class Motion {
 public:
  Motion(codegen::MotionLimits limits, std::uint64_t seed) : limits_(limits), random_(seed) {}
  double next() {
    if (hold_ == 0) {
      target_ = random_.below(5) == 0 ? 0 : limits_.velocity * random_.between(-1, 1);
      hold_ = 10 + random_.below(300);
    }
    --hold_;
    velocity_ += std::clamp(target_ - velocity_, -limits_.acceleration, limits_.acceleration);
    return position_ += velocity_;
  }

 private:
  codegen::MotionLimits limits_;
  test::Random random_;
  double position_ = 1e6, velocity_ = 0, target_ = 0;
  std::uint32_t hold_ = 0;
};

/// The larger one of both images, from their proof records.
double peak_gain(std::size_t axis) {
  double largest = 0;
  for (int const variant : {0, 1}) {
    auto const image = codegen::write_image(machine_variant(variant), {});
    largest = std::max(largest, test::contents_of(image).axes[axis].peak_gain);
  }
  return largest;
}

/// First and second differences over their bounds; at most 1 is good.
class Watch {
 public:
  Watch(codegen::MotionLimits limits, double peak_gain) : limits_(limits), peak_gain_(peak_gain) {}
  void see(double y) {
    if (seen_ > 1) {
      // Rounding of positions, twice.
      double const rounding =
          4 * (std::nextafter(std::abs(y), std::numeric_limits<double>::infinity()) - std::abs(y));
      worst = std::max(worst, (std::abs(y - y1_) - rounding) / (limits_.velocity * (peak_gain_ + 0.25)));
      worst = std::max(worst, (std::abs(y - 2 * y1_ + y2_) - rounding) /
                                  (limits_.acceleration * (peak_gain_ + 0.25 + 1.0 / 64)));
    }
    ++seen_;
    y2_ = y1_;
    y1_ = y;
  }
  double worst = 0;

 private:
  codegen::MotionLimits limits_;
  double peak_gain_;
  double y1_ = 0, y2_ = 0;
  int seen_ = 0;
};

/// Cheaper than the macro, in millions of cycles.
void require(bool condition) {
  if (!condition) FAIL("a call of the runtime gave what it should not");
}

/// Filters off, on, the end of a program; what comes of it is the runtime's business.
void command_something(axisrt* runtime, test::Random& random) {
  constexpr std::uint32_t actions[] = {AXISRT_ACTION_OFF, AXISRT_ACTION_ON, AXISRT_ACTION_PROGRAM_END};
  axisrt_filter_command command{};
  command.size = sizeof command;
  command.action = actions[random.below(3)];
  axisrt_status const status = axisrt_command(runtime, 0, &command);
  require(status == AXISRT_OK || status == AXISRT_BUSY);
}

/// Changes between the variants for as many swaps, with commands in between; the worst ratio to the bounds.
double change_often(int swaps, std::uint64_t seed) {
  std::vector<std::byte> const images[] = {codegen::write_image(machine_variant(0), {}),
                                           codegen::write_image(machine_variant(1), {})};
  codegen::MotionLimits const limits = codegen::motion_limits(500'000, 8000, cycle_time);
  auto active = std::make_unique<Made>(images[0]);
  REQUIRE(active->status == AXISRT_OK);
  std::vector<double> in(axes, 1e6);
  std::vector<double> out(axes);
  for (std::uint32_t i = 0; i < axes; ++i) REQUIRE(axisrt_reset(active->runtime, i, 1e6) == AXISRT_OK);
  Motion motion(limits, seed);
  test::Random random(seed + 1);
  std::vector<Watch> watches;
  for (std::size_t i = 0; i < axes; ++i) watches.emplace_back(limits, peak_gain(i));
  auto const cycle = [&](axisrt* runtime) {
    std::fill(in.begin(), in.end(), motion.next());
    require(axisrt_step(runtime, in.data(), out.data(), nullptr) == AXISRT_OK);
    for (std::size_t i = 0; i < axes; ++i) {
      watches[i].see(out[i]);
      axisrt_axis_state state{};
      require(axisrt_get_axis_state(runtime, static_cast<std::uint32_t>(i), &state) == AXISRT_OK);
      require(state.filtered == out[i]);
    }
  };
  for (int swap = 0; swap < swaps; ++swap) {
    for (std::uint32_t wait = random.below(50); wait > 0; --wait) {
      if (random.below(10) == 0) command_something(active->runtime, random);
      cycle(active->runtime);
    }
    auto next = std::make_unique<Made>(images[(swap + 1) % 2], active->runtime);
    REQUIRE(next->status == AXISRT_OK);
    axisrt_status const at_once = axisrt_swap(next->runtime);
    REQUIRE((at_once == AXISRT_NOT_WARM || at_once == AXISRT_BUSY));
    axisrt_status status = AXISRT_NOT_WARM;
    for (int warm = 0; warm < 5000 && status != AXISRT_OK; ++warm) {
      cycle(active->runtime);
      require(axisrt_shadow_step(next->runtime) == AXISRT_OK);
      status = axisrt_swap(next->runtime);
      if (status == AXISRT_BUSY) status = AXISRT_NOT_WARM;  // kernels change over: later
    }
    REQUIRE(status == AXISRT_OK);
    int fade = 0;
    for (; axisrt_swap_done(next->runtime) == 0; ++fade) cycle(next->runtime);
    CHECK(fade > 1);
    active = std::move(next);
  }
  return std::max_element(watches.begin(), watches.end(),
                          [](auto const& a, auto const& b) { return a.worst < b.worst; })
      ->worst;
}

}  // namespace

TEST_CASE("a change of image in motion keeps the bounds of velocity and acceleration", "[change]") {
  CHECK(change_often(40, 7) <= 1);
}

TEST_CASE("thousands of changes of image keep the bounds", "[.][slow][change]") {
  CHECK(change_often(5000, 8) <= 1);
}

TEST_CASE("a million changes of image, with commands in between, keep the bounds", "[.][long][change]") {
  CHECK(change_often(1'000'000, 9) <= 1);
}

TEST_CASE("a prepared runtime gives what the active one gives if the images are equal", "[change]") {
  Made active(machine_variant(0), 3);
  for (std::uint32_t i = 0; i < axes; ++i) REQUIRE(axisrt_reset(active.runtime, i, 1e6) == AXISRT_OK);
  Motion motion({100, 1}, 3);
  std::vector<double> in(axes);
  std::vector<double> before(axes);
  std::vector<double> out(axes);
  Made next(machine_variant(0), 3, active.runtime);
  REQUIRE(next.status == AXISRT_OK);
  Made alone(machine_variant(0), 3);
  for (std::uint32_t i = 0; i < axes; ++i) REQUIRE(axisrt_reset(alone.runtime, i, 1e6) == AXISRT_OK);
  for (int cycle = 0; cycle < 3000; ++cycle) {
    std::fill(in.begin(), in.end(), motion.next());
    bool const swapped = cycle >= 2000;
    REQUIRE(axisrt_step(swapped ? next.runtime : active.runtime, in.data(), out.data(), nullptr) ==
            AXISRT_OK);
    if (!swapped) REQUIRE(axisrt_shadow_step(next.runtime) == AXISRT_OK);
    if (cycle == 1999) REQUIRE(axisrt_swap(next.runtime) == AXISRT_OK);
    REQUIRE(axisrt_step(alone.runtime, in.data(), before.data(), nullptr) == AXISRT_OK);
    REQUIRE(out == before);
  }
}

TEST_CASE("images of other machines and older ones are refused", "[change]") {
  Made active(machine_variant(0), 5);
  machine::Machine other = machine_variant(1);
  other.axes[1].name = "V";
  CHECK(Made(other, 6, active.runtime).status == AXISRT_OTHER_AXES);
  other = machine_variant(1);
  other.axes[2].number = 9;
  CHECK(Made(other, 6, active.runtime).status == AXISRT_OTHER_AXES);
  other = machine_variant(1);
  other.axes.pop_back();
  other.groups[0].axes.pop_back();
  CHECK(Made(other, 6, active.runtime).status == AXISRT_OTHER_AXES);
  other = machine_variant(1);
  CHECK(Made(other, 4, active.runtime).status == AXISRT_OLDER_IMAGE);
  CHECK(Made(other, 4, active.runtime, AXISRT_ALLOW_OLDER).status == AXISRT_OK);
  CHECK(Made(other, 5, active.runtime).status == AXISRT_OK);
}

TEST_CASE("a chain that blocks the constant part and other position control change at standstill only",
          "[change]") {
  for (bool const blocks : {true, false}) {
    Made active(machine_variant(0), 0);
    for (std::uint32_t i = 0; i < axes; ++i) REQUIRE(axisrt_reset(active.runtime, i, 0) == AXISRT_OK);
    machine::Machine changed = machine_variant(1);
    if (blocks) {
      changed.axes[0].filters[0].specification = {
          .type = FilterType::highpass, .order = 1, .frequency = {10}};
    } else {
      changed.axes[0].position_control = test::manual_position_control();
    }
    Made next(changed, 1, active.runtime);
    REQUIRE(next.status == AXISRT_OK);
    std::vector<double> in(axes);
    std::vector<double> out(axes);
    auto const run = [&](int cycles, double velocity) {
      for (int cycle = 0; cycle < cycles; ++cycle) {
        for (double& x : in) x += velocity;
        REQUIRE(axisrt_step(active.runtime, in.data(), out.data(), nullptr) == AXISRT_OK);
        REQUIRE(axisrt_shadow_step(next.runtime) == AXISRT_OK);
      }
    };
    run(3000, 10);
    CHECK(axisrt_swap(next.runtime) == AXISRT_NEEDS_STANDSTILL);
    run(6000, 0);
    // A high-pass gives 0 where the band-stop gives the position: no standstill makes that equal.
    CHECK(axisrt_swap(next.runtime) == (blocks ? AXISRT_NEEDS_STANDSTILL : AXISRT_OK));
    CHECK(axisrt_swap_done(next.runtime) == (blocks ? 0 : 1));
  }
}

TEST_CASE("wrong use of a change is an argument that is refused", "[change]") {
  Made active(machine_variant(0), 0);
  CHECK(axisrt_shadow_step(active.runtime) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_swap(active.runtime) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_swap(nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_swap_done(active.runtime) == 0);
  CHECK(axisrt_swap_done(nullptr) == 0);
}

}  // namespace change_test
