// Against the closed formulas of the filter mathematics, with kernels written down here once more.
#include "analysis/motion/contour/contour_predictions.hpp"

#include "analysis/motion/feed_limits.hpp"
#include "channels.hpp"
#include "plain_geometry.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace axisc::motion::contour_predictions_test {
namespace {

using design::KernelSpecification;
using design::KernelType;
using test::per_cycle;

constexpr double pi = std::numbers::pi;

/// Σ_{k=1..h} k b_k of a kernel b_k, k = -h..h, scaled to a sum of 1.
template <class Tap>
double first_moment(int h, Tap tap) {
  double sum = tap(0);
  double moment = 0;
  for (int k = 1; k <= h; ++k) {
    sum += 2 * tap(k);
    moment += k * tap(k);
  }
  return moment / sum;
}

double expected_moment(KernelSpecification const& kernel, double cycle_time) {
  int const h = static_cast<int>((kernel.order + 1) / 2);
  switch (kernel.type) {
    case KernelType::gaussian: {
      double const sigma = kernel.quality * h / 2.5;
      return first_moment(h, [&](int k) { return std::exp(-0.5 * (k / sigma) * (k / sigma)); });
    }
    case KernelType::windowed_sinc:
      return first_moment(h, [&](int k) {
        double const x = 2 * kernel.frequency.value * cycle_time * k;
        double const sinc = k == 0 ? 1 : std::sin(pi * x) / (pi * x);
        return sinc * (0.54 + 0.46 * std::cos(pi * k / h));
      });
    default: return first_moment(h, [](int) { return 1.0; });
  }
}

double corner_error(KernelSpecification const& kernel, double feed, design::CycleTime cycle_time = {}) {
  auto const answers = test::answers_of(test::channel_of({kernel, kernel}, cycle_time));
  return predict_corner(answers, per_cycle(feed, cycle_time), pi / 2).axis_error[0];
}

}  // namespace

TEST_CASE("the manual's corner: 1 ms, 1000 mm/min, order 40") {
  auto const answers = test::answers_of(test::channel_of({{.order = 40}, {.order = 40}}));
  auto const figures = predict_corner(answers, per_cycle(1000), pi / 2);
  // v T h (h + 1) / (2 (2 h + 1)) with h = 20
  double const expected = per_cycle(1000) * 20 * 21 / (2 * 41);
  CHECK(expected == Approx(853.66).margin(0.01));
  CHECK(figures.axis_error[0] == Approx(expected).epsilon(1e-9));
  CHECK(figures.axis_error[1] == Approx(expected).epsilon(1e-9));
  CHECK(figures.deviation == Approx(std::sqrt(2) * expected).epsilon(1e-9));
}

TEST_CASE("every kernel has the corner error of its sum") {
  for (auto const type : {KernelType::moving_average, KernelType::gaussian, KernelType::windowed_sinc}) {
    for (std::uint32_t const order : {1U, 2U, 7U, 40U, 133U, 200U}) {
      for (double const share : {100.0, 35.0}) {
        KernelSpecification const kernel{
            .type = type, .order = order, .frequency = {25}, .quality = 0.8, .share_percent = share};
        design::CycleTime const cycle_time{500'000};
        double const expected =
            per_cycle(3000, cycle_time) * share / 100 * expected_moment(kernel, cycle_time.seconds());
        INFO(static_cast<int>(type) << " order " << order << " share " << share);
        CHECK(corner_error(kernel, 3000, cycle_time) == Approx(expected).epsilon(1e-6).margin(1e-6));
      }
    }
  }
}

TEST_CASE("double cycle time, feed or order: double error") {
  for (auto const type : {KernelType::moving_average, KernelType::gaussian}) {
    KernelSpecification const kernel{.type = type, .order = 40};
    double const once = corner_error(kernel, 1000);
    CHECK(corner_error(kernel, 2000) == Approx(2 * once).epsilon(1e-9));
    CHECK(corner_error(kernel, 1000, {2'000'000}) == Approx(2 * once).epsilon(1e-9));
    KernelSpecification const wider{.type = type, .order = 80};
    CHECK(corner_error(wider, 1000) == Approx(2 * once).epsilon(0.03));
  }
}

TEST_CASE("any angle: v R |u1 - u0|") {
  auto const answers = test::answers_of(test::channel_of({{.order = 30}, {.order = 30}}));
  double const e = per_cycle(2000) * 15 * 16 / (2 * 31);
  for (double const degrees : {0.0, 20.0, 60.0, 90.0, 120.0, 170.0, 180.0}) {
    double const turn = degrees * pi / 180;
    auto const figures = predict_corner(answers, per_cycle(2000), turn);
    INFO(degrees);
    CHECK(figures.deviation == Approx(2 * e * std::sin(turn / 2)).epsilon(1e-6).margin(1e-6));
    CHECK(figures.axis_error[0] == Approx(e * (1 - std::cos(turn))).epsilon(1e-6).margin(1e-6));
    if (degrees <= 90) CHECK(figures.axis_error[1] == Approx(e * std::sin(turn)).epsilon(1e-6).margin(1e-6));
  }
}

TEST_CASE("a circle shrinks by the kernel's gain") {
  auto const answers = test::answers_of(test::channel_of({{.order = 40}, {.order = 40}}));
  for (double const feed : {1000.0, 20'000.0}) {
    double const radius = 5e4;
    double const theta = per_cycle(feed) / radius;
    double const gain = std::sin(41 * theta / 2) / (41 * std::sin(theta / 2));
    auto const figures = predict_circle(answers, per_cycle(feed), radius);
    CHECK(largest_circle_error(answers, per_cycle(feed), radius) == figures.largest_axis_error());
    CHECK(figures.deviation == Approx(radius * (1 - gain)).epsilon(1e-6));
    CHECK(figures.axis_error[0] == Approx(radius * (1 - gain)).epsilon(1e-6));
    CHECK(figures.axis_error[1] == Approx(radius * (1 - gain)).epsilon(1e-6));
  }
}

TEST_CASE("there and back: one path with symmetric kernels, two with a PT1") {
  constexpr double nanometre = 0.01;
  for (auto const type : {KernelType::moving_average, KernelType::gaussian, KernelType::windowed_sinc}) {
    KernelSpecification const kernel{.type = type, .order = 40};
    auto const answers = test::answers_of(test::channel_of({kernel, kernel}));
    CHECK(predict_parallel(answers, per_cycle(4000)) < nanometre);
  }
  CHECK(predict_parallel(test::answers_of(test::channel_of_pt1(10'000, 2)), per_cycle(4000)) > 100);
}

TEST_CASE("different delays bend straight lines, equal ones do not") {
  KernelSpecification const slow{.order = 40};
  KernelSpecification const delay{.type = KernelType::time_delay, .order = 20};
  KernelSpecification const short_delay{.type = KernelType::time_delay, .order = 12};
  double const v = per_cycle(6000);
  CHECK(predict_line(test::answers_of(test::channel_of({slow, delay})), v).deviation < 1e-6);
  // One axis runs v (20 - 12)/√2 ahead; half of it stands across the line.
  auto const bent = predict_line(test::answers_of(test::channel_of({slow, short_delay})), v);
  CHECK(bent.deviation == Approx(v * 8 / 2).epsilon(1e-6));
}

TEST_CASE("the third axis is judged at a corner with the first") {
  auto const answers = test::answers_of(test::channel_of({{.order = 40}, {.order = 40}, {.order = 40}}));
  auto const figures = predict_corner(answers, 100, pi / 2);
  for (std::size_t axis = 0; axis < 3; ++axis) CHECK(figures.axis_error[axis] == Approx(100 * 210.0 / 41));
  auto const mixed = test::answers_of(test::channel_of({{.order = 40}, {.order = 40}, {.order = 0}}));
  CHECK(predict_corner(mixed, 100, pi / 2).deviation > figures.deviation);
}

TEST_CASE("the feed that keeps a tolerance has that error") {
  auto const answers = test::answers_of(test::channel_of({{.order = 40}, {.order = 40}}));
  auto const corner = corner_velocity(answers, pi / 2, 10);
  REQUIRE(corner.has_value());
  CHECK(predict_corner(answers, *corner, pi / 2).largest_axis_error() == Approx(10));
  auto const circle = circle_velocity(answers, 1e5, 10);
  REQUIRE(circle.has_value());
  CHECK(predict_circle(answers, *circle, 1e5).largest_axis_error() == Approx(10));
  // Setpoints that come to rest in the centre are away by the radius, and no tolerance above it is exceeded.
  CHECK_FALSE(circle_velocity(answers, 1e5, 1.01e5).has_value());
  auto const unfiltered = test::answers_of(test::channel_of({{.order = 0}, {.order = 0}}));
  CHECK_FALSE(corner_velocity(unfiltered, pi / 2, 10).has_value());
  CHECK_FALSE(circle_velocity(unfiltered, 1e5, 10).has_value());
}

namespace {

/// Σ b_k cos kθ of a symmetric kernel.
double symmetric_gain(std::vector<double> const& taps, double theta) {
  double sum = 0;
  double const middle = static_cast<double>(taps.size() - 1) / 2;
  for (std::size_t n = 0; n < taps.size(); ++n) {
    sum += taps[n] * std::cos(theta * (static_cast<double>(n) - middle));
  }
  return sum;
}

/// The first angle per cycle at which the circle is further away than that, stepping finely; none up to half
/// a turn.
std::optional<double> first_excess(std::vector<double> const& taps, double radius, double tolerance) {
  for (double theta = 1e-5; theta <= pi; theta += 1e-5) {
    if (radius * std::abs(1 - std::abs(symmetric_gain(taps, theta))) > tolerance) return theta;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("the feed for a circle is the first that exceeds the tolerance") {
  SECTION("many radians per cycle") {
    // 1 - (1 + 2 cos θ) / 3 = 0.1: 8322 mm/min at 4 ms and 1 mm
    design::CycleTime const cycle_time{4'000'000};
    auto const answers = test::answers_of(test::channel_of({{.order = 2}, {.order = 2}}, cycle_time));
    auto const circle = circle_velocity(answers, 1e4, 1e3);
    REQUIRE(circle.has_value());
    CHECK(*circle == Approx(1e4 * std::acos(0.85)).epsilon(1e-9));
    CHECK(*circle / per_cycle(1, cycle_time) == Approx(8322).epsilon(1e-3));
  }
  SECTION("a hump that a coarse search steps over") {
    KernelSpecification const kernel{.type = KernelType::windowed_sinc, .order = 120, .frequency = {40}};
    auto const answers = test::answers_of(test::channel_of({kernel, kernel}));
    auto const taps = test::sinc_taps(120, 40, 0.001);
    for (double const tolerance : {43.719, 44.1, 30.0, 60.0, 9000.0}) {
      auto const expected = first_excess(taps, 1e4, tolerance);
      auto const circle = circle_velocity(answers, 1e4, tolerance);
      INFO(tolerance);
      REQUIRE(expected.has_value());
      REQUIRE(circle.has_value());
      CHECK(*circle == Approx(1e4 * *expected).margin(0.2));
    }
    // |1 - |G|| is at most 1.
    CHECK_FALSE(circle_velocity(answers, 1e4, 1.1e4).has_value());
  }
}

TEST_CASE("corners of slow filters are looked at in every cycle") {
  design::CycleTime const cycle_time{4'000'000};
  auto machine = test::channel_of_pt1(80'000, 2);
  machine.cycle_time = cycle_time;
  auto const figures = predict_corner(test::answers_of(machine), per_cycle(2500, cycle_time), pi / 2);
  // Setpoints long before the corner and long behind it, through the PT1.
  double const v = per_cycle(2500, cycle_time);
  std::vector<test::Place> setpoints;
  for (int n = -999; n <= 1000; ++n) {
    setpoints.push_back(n < 0 ? test::Place{v * n, 0} : test::Place{0, v * n});
  }
  auto const taps = test::pt1_taps(80'000, cycle_time.seconds());
  // At the start the axes rest, far away: only the corner's surroundings count.
  auto const all = test::distances({{-1000 * v, 0}, {-300 * v, 0}, {0, 0}, {0, 300 * v}, {0, 1000 * v}},
                                   setpoints, {taps, taps}, 0);
  auto const expected = test::largest_of({all[1], all[2]});
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(figures.axis_error[i] == Approx(expected.axis_error[i]).epsilon(1e-4));
  }
  CHECK(figures.deviation == Approx(expected.deviation).epsilon(1e-4));
}

}  // namespace axisc::motion::contour_predictions_test
