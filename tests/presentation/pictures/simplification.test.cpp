#include "presentation/pictures/simplification.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace simplification_test {

using namespace axisc::pictures;

namespace {

/// Height of the simplified line at a point's place.
double height_at(std::vector<Point> const& line, double x) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (x > line[i].x) continue;
    double const share = (x - line[i - 1].x) / (line[i].x - line[i - 1].x);
    return line[i - 1].y + share * (line[i].y - line[i - 1].y);
  }
  return line.back().y;
}

}  // namespace

TEST_CASE("of a straight line its ends are left") {
  std::vector<Point> points;
  for (int i = 0; i <= 100; ++i) points.push_back({.x = i * 0.5, .y = i * 2.0});
  CHECK(simplified(points, 0.05).size() == 2);
}

TEST_CASE("no point is farther than the tolerance from a simplified curve") {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.05);
  for (int run = 0; run < 50; ++run) {
    std::vector<Point> points;
    for (int i = 0; i < 400; ++i)
      points.push_back({.x = i * 0.7, .y = 80 * std::sin(i * 0.02 * run) + noise(random)});
    auto const line = simplified(points, 0.1);
    CHECK(line.size() <= points.size());
    CHECK(line.front().x == points.front().x);
    CHECK(line.back().x == points.back().x);
    for (auto const& point : points) CHECK(std::abs(height_at(line, point.x) - point.y) <= 0.1 + 1e-9);
  }
}

TEST_CASE("interruptions stay, and a curve that turns back is left alone") {
  std::vector<Point> const interrupted{{.x = 0, .y = 0},   {.x = 1, .y = 1}, {.x = 2, .y = 2},
                                       {.x = 2, .y = NAN}, {.x = 3, .y = 0}, {.x = 4, .y = 0},
                                       {.x = 5, .y = 0}};
  auto const line = simplified(interrupted, 0.05);
  REQUIRE(line.size() == 5);
  CHECK(line[1].x == 2);
  CHECK(std::isnan(line[2].y));
  CHECK(line[3].x == 3);
  std::vector<Point> const turning{{.x = 0, .y = 0}, {.x = 1, .y = 0}, {.x = 0.5, .y = 0}, {.x = 2, .y = 0}};
  CHECK(simplified(turning, 0.05).size() == turning.size());
}

}  // namespace simplification_test
