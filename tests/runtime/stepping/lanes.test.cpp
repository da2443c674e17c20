// Axes side by side: whatever their number and whatever they have in common, each is filtered as if it were
// alone.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/exact_kernel.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace lanes_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;

/// An axis and its exact evaluation.
struct Axis {
  std::vector<ExactFilter> filters;
  std::optional<std::uint32_t> kernel;
  std::uint32_t family = 2;
  double start = 0;
  double x = 0, v = 0, distance = 0;
  bool blocks = false;
};

class Machine {
 public:
  Machine(std::vector<Axis> axes, std::vector<KernelRecord> kernels)
      : axes_(std::move(axes)), kernels_(std::move(kernels)) {
    ImageRecord image;
    image.kernels = kernels_;
    std::uint32_t history = 0;
    for (KernelRecord const& kernel : kernels_) {
      history = std::max(history, static_cast<std::uint32_t>(kernel.tails.size()));
    }
    for (std::uint32_t i = 0; i < axes_.size(); ++i) {
      Axis const& axis = axes_[i];
      image.axes.emplace_back();
      for (ExactFilter const& filter : axis.filters) {
        image.axes[i].filters.push_back(filter.record());
        image.axes[i].filters.back().index = static_cast<std::uint32_t>(image.axes[i].filters.size() - 1);
      }
      if (axis.kernel) {
        // Some of the histories are longer than they need to be, as those of axes with longer banks are.
        std::uint32_t const own =
            i % 3 == 0 ? history : static_cast<std::uint32_t>(kernels_[*axis.kernel].tails.size());
        image.slots.push_back({.axis = i, .family = axis.family, .kernel = *axis.kernel, .history = own});
      }
    }
    runtime_.emplace(write_image(image));
    REQUIRE(runtime_->status == AXISRT_OK);
    for (Axis& axis : axes_) {
      chains_.emplace_back(axis.filters, axis.start);
      slots_.emplace_back(axis.kernel ? kernels_[*axis.kernel].tails : std::vector<double>{}, axis.start);
      axis.x = axis.start;
      REQUIRE(axisrt_reset(runtime_->runtime, static_cast<std::uint32_t>(chains_.size() - 1), axis.start) ==
              AXISRT_OK);
    }
  }

  /// Largest error over its bound.
  double run(int cycles, unsigned seed) {
    std::mt19937 random(seed);
    double worst = 0;
    std::vector<double> in(axes_.size());
    for (int cycle = 0; cycle < cycles; ++cycle) {
      for (std::size_t i = 0; i < axes_.size(); ++i) {
        Axis& axis = axes_[i];
        auto const event = static_cast<unsigned>(random() % 64);
        if (event == 0) axis.v = 0;
        if (event > 40) axis.v += static_cast<double>(random()) * 0x1p-28 - 8;
        in[i] = axis.x += axis.v;
      }
      std::vector<double> const out = runtime_->step_all(in);
      for (std::size_t i = 0; i < axes_.size(); ++i)
        worst = std::max(worst, error_over_bound(i, in[i], out[i]));
    }
    return worst;
  }

 private:
  double error_over_bound(std::size_t i, double x, double y) {
    Axis& axis = axes_[i];
    bool const hsc = axis.kernel && axis.family == 1;
    Quad exact = x;
    if (hsc) exact = slots_[i].step(exact);
    exact = chains_[i].step(exact);
    if (axis.kernel && !hsc) exact = slots_[i].step(exact);
    axis.distance = std::max(axis.distance, std::fabs(axis.blocks ? x - axis.start : y - x));
    double const largest = std::max(std::fabs(x), std::fabs(y));
    double const ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
    return static_cast<double>(absolute(static_cast<Quad>(y) - exact)) /
           (ulp / 2 + std::ldexp(axis.distance, -42));
  }

  std::vector<Axis> axes_;
  std::vector<KernelRecord> kernels_;
  std::vector<ExactChain> chains_;
  std::vector<ExactKernel> slots_;
  std::optional<TestRuntime> runtime_;
};

std::vector<KernelRecord> kernels() {
  std::vector<double> bell(101);
  for (std::size_t k = 0; k < bell.size(); ++k) bell[k] = std::exp(-static_cast<double>(k * k) / 2000);
  return {moving_average(100), symmetric_kernel(bell), delay_kernel(13),
          moving_average(4),   delay_kernel(1),        symmetric_kernel({9, 7, 4, 1})};
}

/// Chain number `kind`, a little different on each axis.
Axis chain(unsigned kind, unsigned variant) {
  Quad const f = 20 + static_cast<Quad>(variant);
  Axis axis;
  axis.start = variant % 2 == 0 ? 1e9 : -12345.678 * variant;
  switch (kind) {
    case 0: break;
    case 1:
      axis.filters = {exact::bandstop_of_order_3(f, T, 4), exact::lowpass(f * 4, T, 0.7)};
      axis.filters.resize(variant % 3 == 2 ? 1 : 2);
      break;
    case 2: axis.filters = {exact::pt1(f, T)}; break;
    case 3: axis.filters = {exact::with_share(exact::bandstop(f, T, 3), 0.25), exact::pt2(f, T)}; break;
    case 4:
      axis.filters = {exact::with_share(exact::highpass(f, T, 0.7), 0.5), exact::lowpass(f, T, 1)};
      if (variant % 3 == 1)
        axis.filters[0] = exact::joined(exact::highpass(f, T, 0.5), exact::highpass(f, T, 1));
      axis.blocks = true;
      break;
    case 5: axis.filters = {exact::pt2(f, T), exact::delay(7), exact::bandstop(f, T, 2)}; break;
    case 6: axis.filters = {exact::with_share(exact::delay(5), 0.3)}; break;
    default:
      axis.filters = {exact::bandstop(f, T, 5), exact::bandstop(f + 7, T, 5),
                      exact::bandstop_of_order_3(f + 15, T, 5)};
      break;
  }
  return axis;
}

constexpr unsigned kinds = 8;

}  // namespace

TEST_CASE("1 to 20 axes of one kind of chain agree with the exact evaluation") {
  for (unsigned kind = 0; kind < kinds; ++kind) {
    for (unsigned const count : {1U, 2U, 3U, 4U, 5U, 8U, 9U, 20U}) {
      INFO(kind << ", " << count << " axes");
      std::vector<Axis> axes;
      for (unsigned i = 0; i < count; ++i) axes.push_back(chain(kind, i));
      CHECK(Machine(axes, {}).run(300, count) <= 1);
    }
  }
}

TEST_CASE("axes with one kernel in common, or each with its own, agree with the exact evaluation") {
  for (bool const common : {true, false}) {
    for (std::uint32_t kernel = 0; kernel < kernels().size(); ++kernel) {
      for (unsigned const count : {1U, 2U, 3U, 4U, 6U, 8U, 9U}) {
        INFO((common ? "common " : "own ") << kernel << ", " << count << " axes");
        std::vector<Axis> axes;
        for (unsigned i = 0; i < count; ++i) {
          axes.push_back(chain(common ? 0 : 2, i));
          axes.back().kernel = common ? kernel : (kernel + i) % static_cast<unsigned>(kernels().size());
          axes.back().family = kernel % 2 + 1;
        }
        CHECK(Machine(axes, kernels()).run(700, count) <= 1);
      }
    }
  }
}

TEST_CASE("axes of all kinds in any order agree with the exact evaluation") {
  for (unsigned seed = 0; seed < 12; ++seed) {
    INFO(seed);
    std::mt19937 random(seed);
    std::vector<Axis> axes;
    for (unsigned i = 0; i < 24; ++i) {
      axes.push_back(chain(static_cast<unsigned>(random()) % kinds, i));
      if (random() % 2 == 0 && !axes.back().blocks) {
        axes.back().kernel = static_cast<std::uint32_t>(random() % kernels().size());
        axes.back().family = static_cast<std::uint32_t>(random() % 2 + 1);
      }
    }
    CHECK(Machine(axes, kernels()).run(400, seed) <= 1);
  }
}

TEST_CASE("axes of more shapes than are grouped agree with the exact evaluation") {
  std::vector<Axis> axes;
  for (unsigned i = 0; i < 210; ++i) {
    // Each of a hundred shapes on two axes that are far apart, some of them with a kernel besides.
    axes.push_back(chain(2, i));
    axes.back().filters.push_back(exact::with_share(exact::delay(1 + i % 100), 0.3));
    if (i % 9 == 0) axes.back().kernel = i % 2;
  }
  CHECK(Machine(axes, kernels()).run(250, 1) <= 1);
}

TEST_CASE("an image with a shape for each of many axes is created as any other") {
  constexpr std::uint32_t count = 3000;
  ImageRecord image;
  image.strip = true;
  for (std::uint32_t i = 0; i < count; ++i) {
    AxisRecord axis;
    axis.filters = {exact::delay(1 + i % 100).record(), exact::delay(1 + i / 100).record()};
    axis.filters[1].index = 1;
    image.axes.push_back(axis);
  }
  TestRuntime runtime(write_image(image));
  REQUIRE(runtime.status == AXISRT_OK);
  runtime.reset_all(0);
  std::vector<std::uint32_t> arrived(count, 0);
  for (std::uint32_t cycle = 0; cycle < 140; ++cycle) {
    std::vector<double> const out = runtime.step_all(std::vector<double>(count, 100));
    for (std::uint32_t i = 0; i < count; ++i) {
      if (out[i] == 100 && arrived[i] == 0) arrived[i] = cycle;
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) REQUIRE(arrived[i] == 2 + i % 100 + i / 100);
}

}  // namespace lanes_test
