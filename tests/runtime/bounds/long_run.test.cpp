// Errors do not gather: double arithmetic beside 113 bits, in windows of a run of a billion cycles.
#include "bounded_image.hpp"
#include "runtime/exact_filter.hpp"
#include "runtime/test_runtime.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace long_run_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;
constexpr std::uint64_t window = 2000;
constexpr double most_move = 2000;
constexpr double half_of_last_digit = 0x1p-34;  ///< of positions from 2^19 to 2^20

/// A position within 1000 of 1e6, noise that can be had again for every cycle (splitmix64).
double setpoint(std::uint64_t cycle) {
  std::uint64_t z = (cycle + 1) * 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  z ^= z >> 31U;
  return 1e6 + (static_cast<double>(z >> 11U) * 0x1p-52 - 1) * (most_move / 2);
}

/// One filter of each kind at this frequency.
std::vector<FilterRecord> filters_at(int frequency) {
  Quad const f = frequency;
  return {exact::lowpass(f, T, 0.7).record(),
          exact::bandstop(f, T, 3).record(),
          exact::allpass(f, T, 1).record(),
          exact::pt1(f, T).record(),
          exact::pt2(f, T).record(),
          exact::bandstop_of_order_3(f, T, 2).record(),
          exact::with_share(exact::lowpass(f, T, 2), 0.6).record(),
          exact::with_share(exact::bandstop(f, T, 8), 0.9).record()};
}

/// Each filter as an axis of its own.
ImageRecord image_of_axes(std::vector<FilterRecord> const& filters) {
  ImageRecord image;
  for (auto const& filter : filters) image.axes.emplace_back().filters = {filter};
  return image;
}

/// What is left of a state after this many cycles is far below what is looked for.
std::uint64_t forgetting(axisc::runtime::bounds::BoundRecord const& bound) {
  return 4ULL * bound.cycles;
}

/// All axes have the same setpoint.
class Run {
 public:
  explicit Run(std::vector<FilterRecord> const& filters)
      : filters_(filters),
        bounds_(bounds_of(write_image(image_of_axes(filters)))),
        runtime_(with_bounds(image_of_axes(filters))),
        in_(filters.size()),
        out_(filters.size()) {
    REQUIRE(runtime_.status == AXISRT_OK);
    REQUIRE(bounds_.size() == filters.size());
    runtime_.reset_all(setpoint(0));
  }

  /// The largest error of each filter in the window that begins after this many cycles.
  std::vector<double> errors_after(std::uint64_t cycles) {
    while (cycle_ < cycles) step(setpoint(cycle_ + 1));
    std::vector<std::vector<double>> outputs;
    for (std::uint64_t n = 0; n < window; ++n) {
      step(setpoint(cycle_ + 1));
      outputs.push_back(out_);
    }
    std::vector<double> errors;
    for (std::size_t axis = 0; axis < filters_.size(); ++axis) {
      std::uint64_t const begin = cycles - std::min(cycles, forgetting(bounds_[axis]));
      ExactChain exact({stored_filter(filters_[axis])}, setpoint(begin));
      for (std::uint64_t n = begin + 1; n <= cycles; ++n) static_cast<void>(exact.step(setpoint(n)));
      double largest = 0;
      for (std::uint64_t n = 0; n < window; ++n) {
        double const y = outputs[n][axis];
        Quad const wanted = exact.step(setpoint(cycles + 1 + n));
        largest = std::max(largest, static_cast<double>(absolute(Quad(y) - wanted)));
      }
      CAPTURE(axis, cycles, largest);
      CHECK(largest <= half_of_last_digit + most_move * bounds_[axis].rounding_increment);
      errors.push_back(largest);
    }
    return errors;
  }

  /// Every axis is exactly at rest after the cycles that its bound says.
  void come_to_rest() {
    std::uint64_t longest = 0;
    for (auto const& bound : bounds_) longest = std::max(longest, bound.rest_cycles);
    double const x = setpoint(cycle_);
    for (std::uint64_t n = 1; n <= longest + window; ++n) {
      step(x);
      for (std::size_t axis = 0; axis < filters_.size(); ++axis) {
        if (n >= bounds_[axis].rest_cycles && out_[axis] != x) FAIL("axis " << axis << " is not at rest");
      }
    }
  }

 private:
  void step(double x) {
    std::fill(in_.begin(), in_.end(), x);
    if (axisrt_step(runtime_.runtime, in_.data(), out_.data(), nullptr) != AXISRT_OK) FAIL("a step failed");
    ++cycle_;
  }

  std::vector<FilterRecord> filters_;
  std::vector<axisc::runtime::bounds::BoundRecord> bounds_;
  TestRuntime runtime_;
  std::vector<double> in_, out_;
  std::uint64_t cycle_ = 0;
};

double mean(std::vector<double> const& errors) {
  double sum = 0;
  for (double const error : errors) sum += error;
  return sum / static_cast<double>(errors.size());
}

void run_long(std::vector<FilterRecord> const& filters, std::vector<std::uint64_t> const& windows) {
  Run run(filters);
  double const first = mean(run.errors_after(windows.front()));
  for (std::size_t i = 1; i < windows.size(); ++i) {
    double const later = mean(run.errors_after(windows[i]));
    CAPTURE(first, later);
    CHECK(later < 1.5 * first);
  }
  run.come_to_rest();
}

}  // namespace

TEST_CASE("errors do not gather in two hundred thousand cycles", "[bounds]") {
  run_long(filters_at(40), {20'000, 200'000});
}

TEST_CASE("errors do not gather in a billion cycles", "[.long][bounds]") {
  std::vector<FilterRecord> filters;
  for (int const frequency : {5, 20, 60, 150}) {
    auto const more = filters_at(frequency);
    filters.insert(filters.end(), more.begin(), more.end());
  }
  run_long(filters, {1'000'000, 10'000'000, 100'000'000, 1'000'000'000});
}

}  // namespace long_run_test
