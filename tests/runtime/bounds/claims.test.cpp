// What loaders demand of the section `bounds`, and what is found by computing it again.
#include "bounded_image.hpp"
#include "runtime/exact_filter.hpp"
#include "runtime/test_runtime.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace claims_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;

/// Two axes with filters and a kernel before or behind them, a delay, an interface and a stage.
ImageRecord machine() {
  ImageRecord image;
  image.axes.resize(2);
  image.axes[0].filters = {exact::bandstop(30, T, 3).record(), exact::delay(3).record()};
  image.axes[0].filters[1].index = 1;
  image.axes[0].interface_filters = {exact::pt1(50, T).record()};
  image.axes[1].number = 2;
  image.axes[1].filters = {exact::with_share(exact::lowpass(80, T, 0.7), 0.5).record()};
  image.kernels = {moving_average(4), delay_kernel(3, 0.5)};
  image.slots = {{.axis = 0, .kernel = 0, .history = 8, .group = 0},
                 {.axis = 1, .family = 1, .kernel = 1, .history = 8, .group = 0}};
  image.groups = {{.name = "c",
                   .members = {0, 1},
                   .banks = {{.fade_cycles = 1000, .choices = {1, none}}},
                   .off_fade_cycles = 1000}};
  image.controls = {{.axis = 0,
                     .source = 0,
                     .stages = {{.filters = {exact::highpass(9, T, 0.7).record()}}},
                     .limit = 1000}};
  return image;
}

axisrt_status verify(Bytes const& image) {
  AlignedMemory const memory(image);
  return axisrt_verify(memory.data(), memory.size());
}

axisrt_status check(Bytes const& image, std::uint32_t& record, std::uint32_t most_cycles = 1U << 22U) {
  AlignedMemory const memory(image);
  return axisrt_check_bounds(memory.data(), memory.size(), most_cycles, &record);
}

double number_at(Bytes const& image, std::size_t at) {
  return std::bit_cast<double>(peek(image, at, 8));
}

}  // namespace

TEST_CASE("an image with bounds is accepted, and its bounds hold", "[bounds]") {
  Bytes const image = with_bounds(machine());
  CHECK(verify(image) == AXISRT_OK);
  std::uint32_t records = 0;
  CHECK(check(image, records) == AXISRT_OK);
  // X alone and with two kernels, its interface, Y alone and with its kernel, the stage.
  CHECK(records == 7);
  CHECK(check(image, records, 100) == AXISRT_BOUND_FAILED);
  CHECK(records == 0);
  CHECK(check(write_image(machine()), records) == AXISRT_BOUND_FAILED);
  CHECK(axisrt_check_bounds(nullptr, 0, 1, &records) == AXISRT_BAD_ARGUMENT);
}

TEST_CASE("every field that is moved to the wrong side by 2^-38 fails", "[bounds]") {
  Bytes const image = with_bounds(machine());
  std::size_t const first = section_offset(image, bounds_kind);
  std::size_t cases = 0;
  for (std::uint32_t record = 0; record < 7; ++record) {
    for (std::size_t field = 24; field < 112; field += 8) {
      std::size_t const at = first + record * bound_size + field;
      Bytes changed = image;
      if (field == 96) {
        poke(changed, at, peek(image, at, 8) - 1, 8);
      } else {
        double const value = number_at(image, at);
        if (value == 0) continue;
        poke_f64(changed, at, value * (field == 24 ? 1 + 0x1p-38 : 1 - 0x1p-38));
      }
      repair_checksums(changed);
      CAPTURE(record, field);
      std::uint32_t failing = 99;
      // Some are impossible: a loader sees them.
      if (verify(changed) == AXISRT_OK) {
        CHECK(check(changed, failing) == AXISRT_BOUND_FAILED);
        CHECK(failing == record);
      } else {
        CHECK(verify(changed) == AXISRT_OUT_OF_BOUNDS);
      }
      ++cases;
    }
    Bytes changed = image;
    poke(changed, first + record * bound_size + 16, 64, 4);
    repair_checksums(changed);
    std::uint32_t failing = 99;
    CHECK(check(changed, failing) == AXISRT_BOUND_FAILED);
  }
  CHECK(cases > 60);
}

TEST_CASE("more than what is computed is true as well", "[bounds]") {
  Bytes image = with_bounds(machine());
  std::size_t const first = section_offset(image, bounds_kind);
  for (std::size_t const field : {32U, 40U, 48U, 64U, 80U}) {
    poke_f64(image, first + field, number_at(image, first + field) * 1.5);
  }
  poke_f64(image, first + 24, 0.5);
  repair_checksums(image);
  std::uint32_t records = 0;
  CHECK(check(image, records) == AXISRT_OK);
}

TEST_CASE("a loader refuses bounds that are impossible, incomplete or in another order", "[bounds]") {
  Bytes const image = with_bounds(machine());
  std::size_t const first = section_offset(image, bounds_kind);
  auto const refused = [&](std::size_t field, double value) {
    Bytes changed = image;
    poke_f64(changed, first + field, value);
    repair_checksums(changed);
    return verify(changed);
  };
  CHECK(refused(24, 3) == AXISRT_OUT_OF_BOUNDS);            // gain_low above gain_high
  CHECK(refused(32, 1 - 0x1p-40) == AXISRT_OUT_OF_BOUNDS);  // H(1) = 1
  CHECK(refused(40, -0x1p-60) == AXISRT_OUT_OF_BOUNDS);
  CHECK(refused(56, 1.5) == AXISRT_OUT_OF_BOUNDS);
  CHECK(refused(64, std::numeric_limits<double>::infinity()) == AXISRT_NOT_FINITE);
  CHECK(refused(104, std::nan("")) == AXISRT_NOT_FINITE);
  for (std::size_t const field : {0U, 4U, 8U, 12U, 20U}) {
    Bytes changed = image;
    poke(changed, first + field, 2, 4);
    repair_checksums(changed);
    CHECK(verify(changed) == AXISRT_OUT_OF_BOUNDS);
  }

  ImageRecord shorter = machine();
  auto records = bounds_of(write_image(shorter));
  std::swap(records[1], records[2]);
  shorter.foreign = section_of(records);
  CHECK(verify(write_image(shorter)) == AXISRT_OUT_OF_BOUNDS);
  std::swap(records[1], records[2]);
  records.pop_back();
  shorter.foreign = section_of(records);
  CHECK(verify(write_image(shorter)) == AXISRT_OUT_OF_BOUNDS);
}

TEST_CASE("fades that add more than a quarter of the limits fail", "[bounds]") {
  ImageRecord image = machine();
  image.groups[0].off_fade_cycles = 20;
  std::uint32_t record = 99;
  CHECK(check(with_bounds(image), record) == AXISRT_BOUND_FAILED);
  CHECK(record == 0);
}

TEST_CASE("with bounds the limit of outputs is that of kernel and filters together", "[bounds]") {
  // The kernel amplifies what the low-pass then takes away: the product of both gains is never reached.
  ImageRecord image = image_of({exact::lowpass(60, T, 0.7).record()});
  image.kernels = {symmetric_kernel({1, -0.2})};
  image.kernels[0].peak_gain = 1.4 / 0.6;
  image.slots = {{.axis = 0, .family = 1, .kernel = 0, .history = 2}};
  auto const records = bounds_of(write_image(image));
  double const joint = std::max(records.at(0).gain_high, records.at(1).gain_high);
  double const product = records.at(0).gain_high * image.kernels[0].peak_gain;
  REQUIRE(joint < 0.8 * product);
  image.axes[0].peak_gain = product;
  double const v = image.axes[0].velocity_limit * 10 * 1e-3;
  // A jump that moves the output in between.
  double first = 0;
  {
    TestRuntime runtime(write_image(image));
    runtime.reset_all(0);
    first = runtime.step(1);
  }
  double const jump = (0.5 * (joint + product) + 0.25) * v / first;
  for (bool const bounded : {false, true}) {
    TestRuntime runtime(bounded ? with_bounds(image) : write_image(image));
    REQUIRE(runtime.status == AXISRT_OK);
    runtime.reset_all(0);
    runtime.step(jump);
    CHECK(runtime.status == (bounded ? AXISRT_IMPLAUSIBLE : AXISRT_OK));
  }
}

TEST_CASE("setpoints within v are never implausible with bounds, and barely so just beyond", "[bounds]") {
  std::vector<FilterRecord> const chain = GENERATE(
      std::vector<FilterRecord>{exact::bandstop(30, T, 3).record()},
      std::vector<FilterRecord>{exact::lowpass(12, T, 4).record(), exact::allpass(33, T, 0.7).record()},
      std::vector<FilterRecord>{exact::with_share(exact::bandstop(40, T, 2), 0.75).record(),
                                exact::delay(9).record(), exact::pt1(60, T).record()},
      std::vector<FilterRecord>{exact::allpass(400, T, 0.6).record(), exact::lowpass(2, T, 1).record()});
  ImageRecord image = image_of(chain);
  auto const bound = bounds_of(write_image(image)).at(0);
  double const v = image.axes[0].velocity_limit * 10 * 1e-3;
  // Backwards through the signs of h, each increment adds to the last output's: it comes to gain v.
  std::vector<double> h;
  {
    TestRuntime runtime(write_image(image));
    runtime.reset_all(0);
    double before = 0;
    for (std::uint32_t n = 0; n < bound.cycles; ++n) {
      double const y = runtime.step(0x1p20);
      h.push_back(y - before);
      before = y;
    }
  }
  for (double const share : {1.0, (bound.gain_high + 0.26) / bound.gain_high}) {
    TestRuntime runtime(with_bounds(image));
    REQUIRE(runtime.status == AXISRT_OK);
    runtime.reset_all(0);
    double x = 0;
    double y = 0;
    double largest = 0;
    bool implausible = false;
    for (std::size_t n = h.size(); n-- > 0;) {
      double const before = y;
      x += std::copysign(v * share, h[n]);
      y = runtime.step(x);
      implausible = implausible || runtime.status != AXISRT_OK;
      largest = std::max(largest, std::abs(y - before));
    }
    CHECK(implausible == (share > 1));
    if (share == 1) CHECK(largest >= 0.999999 * bound.gain_high * v);
    if (share == 1) CHECK(largest <= bound.gain_high * v * (1 + 1e-12));
  }
}

}  // namespace claims_test
