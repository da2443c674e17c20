#include "presentation/pictures/sampling.hpp"

#include "presentation/pictures/projection.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sampling_test {

using namespace axisc::pictures;

namespace {

/// The curve that the points draw, at any x in range, in pixels.
double drawn(std::vector<Point> const& points, double x, Projection const& across, Projection const& up) {
  auto const after = std::lower_bound(points.begin() + 1, points.end() - 1, x,
                                      [](Point const& p, double at) { return p.x < at; });
  Point const& b = *after;
  Point const& a = *(after - 1);
  double const share = (across(x) - across(a.x)) / (across(b.x) - across(a.x));
  return up(a.y) + (up(b.y) - up(a.y)) * share;
}

}  // namespace

TEST_CASE("the line between sampled points is nowhere a quarter of a pixel from the function") {
  Axis const x{.scale = Scale::logarithmic, .low = 0.05, .high = 500};
  Axis const y{.low = -80, .high = 10};
  for (double const quality : {0.5, 2.0, 10.0, 300.0}) {
    // A notch at 42 Hz.
    auto const notch = [quality](double f) {
      double const r = f / 42;
      double const magnitude = std::abs(1 - r * r) / std::hypot(1 - r * r, r / quality);
      return std::max(20 * std::log10(magnitude), -80.0);
    };
    std::vector<double> const exact{42};
    auto const points = sample(x, y, exact, notch);
    CHECK(points.size() < 2000);
    CHECK(std::any_of(points.begin(), points.end(), [](Point const& p) { return p.x == 42 && p.y == -80; }));
    Projection const across(x, panel_left, panel_right);
    Projection const up(y, usual_panel_height, 0);
    double largest = 0;
    for (int i = 0; i <= 20000; ++i) {
      double const at = 0.05 * std::pow(1e4, i / 20000.0);
      largest = std::max(largest, std::abs(drawn(points, at, across, up) - up(notch(at))));
    }
    CHECK(largest < 0.25);
  }
}

TEST_CASE("jumps and gaps are bracketed closely") {
  Axis const x{.low = 0, .high = 10};
  Axis const y{.low = 0, .high = 1};
  auto const points = sample(x, y, {}, [](double at) {
    return at < 3.3 ? 0.2 : at < 7.7 ? 0.9 : std::numeric_limits<double>::quiet_NaN();
  });
  CHECK(points.size() < 400);
  auto const after = std::find_if(points.begin(), points.end(), [](Point const& p) { return p.y == 0.9; });
  REQUIRE(after != points.begin());
  CHECK(after->x - (after - 1)->x < 1e-3);
  CHECK(std::isnan(points.back().y));
}

}  // namespace sampling_test
