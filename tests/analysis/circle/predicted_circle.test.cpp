// Closed forms of the path that two delayed and damped sines make.
#include "analysis/circle/predicted_circle.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace axisc::circle::predicted_circle_test {
namespace {

constexpr double radius = 50'000;  // µm

TEST_CASE("a delay alone bends the circle by feed times delay") {
  constexpr double feed = 4000.0 * 1000 / 60;  // µm/s
  constexpr double delay = 0.001;
  PredictedCircle const circle{.radius = radius, .phase = feed / radius * delay};
  auto const found = circle.deviations();
  // The textbook's 67 µm, by sin x ≈ x and √(1 ± x) ≈ 1 ± x/2.
  CHECK(*found.bidirectional == Approx(feed * delay).epsilon(1e-6));
  CHECK(*found.bidirectional == Approx(66.67).epsilon(1e-4));
  // At +45° counterclockwise, at -45° clockwise.
  constexpr double eighth = std::numbers::pi / 4;
  CHECK(circle.deviation_at(eighth, Sense::counterclockwise) == Approx(found.radial_max));
  CHECK(circle.deviation_at(eighth, Sense::clockwise) == Approx(found.radial_min));
  CHECK(circle.deviation_at(-eighth, Sense::clockwise) == Approx(found.radial_max));
  CHECK(*found.hysteresis == Approx(*found.bidirectional));
}

TEST_CASE("different gains alone make an ellipse whose semi-axes they are") {
  PredictedCircle const circle{.radius = radius, .gain_u = 0.999, .gain_v = 0.9975};
  auto const found = circle.deviations();
  CHECK(found.radial_max == Approx(-0.001 * radius));
  CHECK(found.radial_min == Approx(-0.0025 * radius));
  CHECK(*found.counterclockwise == Approx(0.0015 * radius));
  CHECK(*found.hysteresis < 1e-9);
  CHECK(circle.deviation_at(0, Sense::clockwise) == Approx(-0.001 * radius));
  CHECK(circle.radius_deviation() == Approx(-0.00175 * radius));
}

TEST_CASE("equal axes leave a circle") {
  auto const found = PredictedCircle{.radius = radius, .gain_u = 0.9, .gain_v = 0.9}.deviations();
  CHECK(*found.bidirectional < 1e-8);
  CHECK(*found.mean_radial == Approx(-0.1 * radius));
}

TEST_CASE("the ellipse is that of its parametric form") {
  PredictedCircle const circle{.radius = radius, .gain_u = 0.98, .gain_v = 0.995, .phase = 0.03};
  for (auto const sense : {Sense::counterclockwise, Sense::clockwise}) {
    for (int i = 0; i < 360; ++i) {
      double const psi = i * std::numbers::pi / 180;
      double const u = circle.gain_u * radius * std::cos(psi - circle.phase / 2);
      double const v = sign_of(sense) * circle.gain_v * radius * std::sin(psi + circle.phase / 2);
      CHECK(std::hypot(u, v) - radius == Approx(circle.deviation_at(std::atan2(v, u), sense)).margin(1e-8));
    }
  }
}

}  // namespace
}  // namespace axisc::circle::predicted_circle_test
