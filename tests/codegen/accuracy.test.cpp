// The accuracy that is promised, through the whole path: design, rounding, image, runtime. T = 125 µs, f0 = 1
// Hz, positions near 1e9 units (100 m in 0.1 µm).
#include "codegen/image_writer.hpp"
#include "exact_filter.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace axisc::codegen::accuracy_test {
namespace {

using design::FilterSpecification;
using design::FilterType;
using design::Prototype;

constexpr design::CycleTime cycle_time{125'000};
constexpr double start = 995e6;
constexpr double target = 1e9;
constexpr int move_cycles = 8000;
constexpr int rest_cycles = 2000;

/// A smooth move on a grid of 1/16 unit.
double setpoint(int cycle) {
  double const t = std::clamp(static_cast<double>(cycle) / move_cycles, 0.0, 1.0);
  double const way = t * t * t * (10 - 15 * t + 6 * t * t);
  return start + std::floor((target - start) * way * 16) / 16;
}

double half_ulp(double value) {
  double const magnitude = std::abs(value);
  return (std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude) / 2;
}

double step(image::RuntimeHost& runtime, double x) {
  std::array<double, 1> value = {x};
  axisrt_status const status = runtime.step(value, value);
  // These moves are faster than an axis may be.
  if (status != AXISRT_OK && status != AXISRT_IMPLAUSIBLE) FAIL("a step was refused");
  return value[0];
}

struct Accuracy {
  double largest_error = 0;
  double worst_of_bound = 0;  ///< largest error / bound
};

/// The reference move and the beginning of the rest behind it, compared with the exact filter in every cycle.
Accuracy measure(image::RuntimeHost& runtime, std::vector<FilterSpecification> const& filters,
                 bool blocks_constant) {
  test::ExactChain exact(filters, cycle_time, start);
  CHECK(runtime.reset(0, start) == AXISRT_OK);
  Accuracy accuracy;
  double largest_distance = 0;
  for (int cycle = 0; cycle < move_cycles + rest_cycles; ++cycle) {
    double const x = setpoint(cycle);
    double const y = step(runtime, x);
    double exact_y = 0;
    double const error = std::abs(exact.error_of(y, x, exact_y));
    largest_distance = std::max(largest_distance, std::abs(blocks_constant ? x - start : exact_y - x));
    double const bound = half_ulp(std::max(std::abs(x), std::abs(exact_y))) + 0x1p-42 * largest_distance;
    accuracy.largest_error = std::max(accuracy.largest_error, error);
    accuracy.worst_of_bound = std::max(accuracy.worst_of_bound, error / bound);
  }
  return accuracy;
}

/// Cycles at rest until the output is the setpoint and stays there for 20,000 more; `longest` if it does not.
int cycles_until_exact(image::RuntimeHost& runtime, int longest) {
  int exact_since = 0;
  for (int cycle = 0; cycle < longest; ++cycle) {
    if (step(runtime, target) != target) exact_since = cycle + 1;
    if (cycle - exact_since >= 20'000) return exact_since;
  }
  return longest;
}

image::RuntimeHost runtime_with(std::vector<FilterSpecification> const& filters) {
  return test::runtime_for(write_image(test::machine_with(filters, cycle_time), {}));
}

constexpr design::Microseconds one_hertz_lag{159'154.94};

}  // namespace

TEST_CASE("filters of 1 Hz at 1e9 units keep the accuracy and end exactly on the setpoint",
          "[image][accuracy]") {
  FilterSpecification const filter = GENERATE(values<FilterSpecification>(
      {{.type = FilterType::lowpass, .prototype = Prototype::critical_damping, .order = 6, .frequency = {1}},
       {.type = FilterType::lowpass, .prototype = Prototype::bessel, .order = 5, .frequency = {1}},
       {.type = FilterType::lowpass, .prototype = Prototype::butterworth, .order = 4, .frequency = {1}},
       {.type = FilterType::lowpass,
        .prototype = Prototype::butterworth,
        .order = 6,
        .frequency = {1},
        .share_percent = 35},
       {.type = FilterType::bandstop,
        .prototype = Prototype::butterworth,
        .order = 3,
        .frequency = {1},
        .quality = 10},
       {.type = FilterType::bandstop,
        .prototype = Prototype::critical_damping,
        .order = 2,
        .frequency = {1},
        .quality = 1,
        .share_percent = 70},
       {.type = FilterType::allpass, .prototype = Prototype::bessel, .order = 6, .frequency = {1}},
       {.type = FilterType::allpass, .prototype = Prototype::butterworth, .order = 3, .frequency = {1}},
       {.type = FilterType::pt1, .time_constant = one_hertz_lag},
       {.type = FilterType::pt2, .time_constant = one_hertz_lag},
       {.type = FilterType::time_delay, .time_constant = {5.4 * 125}}}));
  CAPTURE(static_cast<int>(filter.type), static_cast<int>(filter.prototype), filter.order,
          filter.share_percent);
  image::RuntimeHost runtime = runtime_with({filter});
  CHECK(measure(runtime, {filter}, false).worst_of_bound <= 1);
  constexpr int longest = 2'500'000;
  CHECK(cycles_until_exact(runtime, longest) < longest);

  CHECK(runtime.reset(0, target) == AXISRT_OK);
  CHECK(step(runtime, target) == target);
}

TEST_CASE("filters that block the constant part keep the accuracy", "[image][accuracy]") {
  FilterSpecification const filter = GENERATE(values<FilterSpecification>(
      {{.type = FilterType::highpass, .prototype = Prototype::butterworth, .order = 4, .frequency = {1}},
       {.type = FilterType::highpass,
        .prototype = Prototype::critical_damping,
        .order = 1,
        .frequency = {1},
        .share_percent = 40},
       {.type = FilterType::highpass, .prototype = Prototype::bessel, .order = 5, .frequency = {1}},
       {.type = FilterType::bandpass,
        .prototype = Prototype::butterworth,
        .order = 3,
        .frequency = {1},
        .quality = 10},
       {.type = FilterType::bandpass,
        .prototype = Prototype::bessel,
        .order = 2,
        .frequency = {1},
        .quality = 2.5,
        .share_percent = 60}}));
  CAPTURE(static_cast<int>(filter.type), static_cast<int>(filter.prototype), filter.order,
          filter.share_percent);
  image::RuntimeHost runtime = runtime_with({filter});
  CHECK(measure(runtime, {filter}, true).worst_of_bound <= 1);
}

TEST_CASE("the reference move through three band-stops", "[image][accuracy]") {
  FilterSpecification const band_stop{.type = FilterType::bandstop,
                                      .prototype = Prototype::butterworth,
                                      .order = 3,
                                      .frequency = {1},
                                      .quality = 10};
  std::vector<FilterSpecification> const chain(3, band_stop);
  image::RuntimeHost runtime = runtime_with(chain);
  Accuracy const accuracy = measure(runtime, chain, false);
  CHECK(accuracy.worst_of_bound <= 1);
  CHECK(accuracy.largest_error <= 2.4e-7);
}

TEST_CASE("a whole delay is exact", "[image][accuracy]") {
  image::RuntimeHost runtime = runtime_with({{.type = FilterType::time_delay, .time_constant = {5 * 125}}});
  CHECK(runtime.reset(0, setpoint(0)) == AXISRT_OK);
  bool exact = true;
  for (int cycle = 0; cycle < move_cycles; ++cycle) {
    exact = exact && step(runtime, setpoint(cycle)) == setpoint(std::max(0, cycle - 5));
  }
  CHECK(exact);
}

}  // namespace axisc::codegen::accuracy_test
