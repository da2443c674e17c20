#include "presentation/pictures/clipping.hpp"

#include "support/catch.hpp"

#include <cmath>

namespace clipping_test {

using namespace axisc::pictures;

namespace {

Axis const across{.low = 0, .high = 10};
Axis const up{.low = 0, .high = 10};

}  // namespace

TEST_CASE("a line through a panel is cut at both edges") {
  auto const points = clipped({{.x = -10, .y = -5}, {.x = 20, .y = 10}}, across, up);
  REQUIRE(points.size() == 2);
  CHECK(points[0].x == Approx(0).margin(1e-12));
  CHECK(points[0].y == Approx(0).margin(1e-12));
  CHECK(points[1].x == Approx(10));
  CHECK(points[1].y == Approx(5));
}

TEST_CASE("a curve that leaves and comes back is interrupted") {
  auto const points =
      clipped({{.x = 1, .y = 5}, {.x = 3, .y = 15}, {.x = 5, .y = 5}, {.x = 6, .y = 5}}, across, up);
  REQUIRE(points.size() == 6);
  CHECK(points[1].y == Approx(10));
  CHECK(std::isnan(points[2].y));
  CHECK(points[3].y == Approx(10));
  CHECK(points[5].x == Approx(6));
}

TEST_CASE("of a curve outside nothing is left, nor of one that is not finite") {
  CHECK(clipped({{.x = -5, .y = 0}, {.x = -5, .y = 10}}, across, up).empty());
  CHECK(clipped({{.x = -5, .y = 11}, {.x = 15, .y = 11}}, across, up).empty());
  CHECK(clipped({{.x = 1, .y = NAN}, {.x = 2, .y = 2}}, across, up).empty());
  CHECK(clipped({{.x = 1, .y = 1}}, across, up).empty());
}

}  // namespace clipping_test
