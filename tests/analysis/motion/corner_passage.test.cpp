// Corners as the control passes them, by hand; 1 ms, position units of 0.1 µm: 1 mm/s is 10 units per cycle.
#include "analysis/motion/contour/corner_passage.hpp"

#include "channels.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace axisc::motion::corner_passage_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double mm_per_s = 10;

/// 2000 mm/s², ramps of 50 ms.
PathDynamics two_axes(machine::Slope slope, double weight = 0) {
  PathDynamics dynamics;
  dynamics.channel.slope = slope;
  dynamics.axes.assign(2, test::step_axis(500'000, 2000));
  for (auto& axis : dynamics.axes) axis.acceleration_transition_weight = weight;
  return dynamics;
}

CornerPassage passage(PathDynamics const& dynamics, double turn, double feed_mm_s = 100) {
  return pass_corner(dynamics, {.turn = turn, .feed = feed_mm_s * mm_per_s}).front();
}

}  // namespace

TEST_CASE(
    "a corner of 45 degrees is passed with a T²/tr per change of direction, with ramps on either side") {
  // Y changes by v sin 45°: 2 mm/s · T/tr / sin 45° = 0.0565685 mm/s, and with the weight 500 1.41421 mm/s.
  auto const slow = passage(two_axes(machine::Slope::trapez), pi / 4);
  CHECK(slow.velocity == Approx(0.0565685 * mm_per_s).epsilon(1e-6));
  REQUIRE(slow.slowed_by.has_value());
  CHECK(*slow.slowed_by == 1);
  CHECK(slow.step == Approx(0.04 * mm_per_s));
  // The line at 45° has √2 times the acceleration and the ramp times of one axis.
  double const change = 100 - 0.0565685;
  CHECK(slow.before.ramp_time == Approx((change / 2000 + 0.05) * 1000));
  CHECK(slow.before.ramp_way == Approx(100.0565685 / 2 * (change / 2000 + 0.05) * units_per_mm));
  // 99.94 mm/s are less than a tr = 141.4 mm/s: √(2 Δ t̄ / a).
  double const a = 2000 * std::numbers::sqrt2;
  CHECK(slow.behind.ramp_time == Approx(std::sqrt(2 * change * 0.1 / a) * 1000));
  auto const weighted = passage(two_axes(machine::Slope::trapez, 500), pi / 4);
  CHECK(weighted.velocity == Approx(1.41421 * mm_per_s).epsilon(1e-5));
}

TEST_CASE("the stock list nearly stops at 90 degrees") {
  auto dynamics = two_axes(machine::Slope::trapez);
  for (auto& axis : dynamics.axes) {
    for (auto* const ramp : {&axis.feed.up, &axis.feed.down}) ramp->build_up = ramp->take_back = 300'000;
  }
  // a T²/tr = 2000 · 1e-6 / 0.3 mm/s
  CHECK(passage(dynamics, pi / 2).velocity == Approx(0.00666667 * mm_per_s).epsilon(1e-6));
}

TEST_CASE("with STEP filters bend the corner by what the ramps pass within their reach") {
  auto dynamics = two_axes(machine::Slope::step);
  auto const planes = pass_corner(dynamics, {.turn = pi / 2, .feed = 100 * mm_per_s});
  REQUIRE(planes.size() == 1);
  CHECK(planes[0].velocity == Approx(2 * mm_per_s));
  CHECK(planes[0].before.ramp_time == Approx(98.0 / 2000 * 1000));
  CHECK(planes[0].behind.ramp_way == Approx((100.0 * 100 - 2 * 2) / (2 * 2000) * units_per_mm));
  // 41 taps: e = Σ (v k T + a k² T²/2) / 41, k = 1 to 20: (2 µm · 210 + 1 µm · 2870) / 41.
  auto const answers = test::answers_of(test::channel_of({{.order = 40}, {.order = 40}}));
  auto const found = predict_passage(answers, planes);
  REQUIRE(found.has_value());
  double const error = (2.0 * 210 + 2870) / 41;
  CHECK(found->axis_error[0] == Approx(error * units_per_um));
  CHECK(found->axis_error[1] == Approx(error * units_per_um));
  CHECK(found->deviation == Approx(std::numbers::sqrt2 * error * units_per_um));
}

TEST_CASE("a corner at the lines' velocity bends as at constant velocity") {
  auto const dynamics = two_axes(machine::Slope::trapez, 1000);
  auto const planes = pass_corner(dynamics, {.turn = pi / 2, .feed = 1.5 * mm_per_s});
  CHECK(planes[0].velocity == Approx(1.5 * mm_per_s));
  CHECK_FALSE(planes[0].slowed_by.has_value());
  CHECK(planes[0].before.ramp_time == 0);
  auto const answers = test::answers_of(test::channel_of({{.order = 40}, {.order = 20}}));
  auto const steady = predict_corner(answers, 1.5 * mm_per_s, pi / 2);
  CHECK(predict_passage(answers, planes)->deviation == Approx(steady.deviation));
  // ACC_FACT multiplies a weight above 0, and a vb_max below the feed counts.
  auto const quick = pass_corner(dynamics, {.turn = pi / 2, .feed = 1e4, .acceleration_factor = 3});
  CHECK(quick[0].velocity == Approx(6 * mm_per_s));
  auto limited = dynamics;
  limited.axes[1].feed.velocity = 1000;
  CHECK(passage(limited, pi / 2).velocity == Approx(1 * mm_per_s));
}

TEST_CASE("a simulated corner that lies on a cycle bends as predicted") {
  // STEP, 10 m/s²: from rest to 100 mm/s in 10 cycles and 0.5 mm, 10 mm in 100, down to 10 mm/s in 9 cycles
  // and 0.495 mm.
  auto const machine = test::channel_of({{.order = 40}, {.type = design::KernelType::gaussian, .order = 30}});
  auto const simulated = test::simulated(machine, "G01 F6000\nN10 X10.995\nN20 Y20\n");
  REQUIRE(simulated.blocks.size() == 2);
  CHECK(simulated.blocks[0].cycles == Approx(119));
  auto const planes = pass_corner(test::path_of(machine), {.turn = pi / 2, .feed = test::per_cycle(6000)});
  CHECK(simulated.blocks[0].motion.velocity_out == Approx(planes[0].velocity));
  auto const predicted = predict_passage(test::answers_of(machine), planes);
  REQUIRE(predicted.has_value());
  double const deviation = std::max(simulated.blocks[0].deviation, simulated.blocks[1].deviation);
  CHECK(predicted->deviation == Approx(deviation).epsilon(1e-9));
}

TEST_CASE("each plane has its own passage; one axis is joined by one like it") {
  PathDynamics dynamics = two_axes(machine::Slope::step);
  dynamics.axes.push_back(test::step_axis(500'000, 500));
  auto const planes = pass_corner(dynamics, {.turn = pi / 2, .feed = 1000});
  REQUIRE(planes.size() == 2);
  CHECK(planes[0].velocity == Approx(2 * mm_per_s));
  CHECK(planes[1].velocity == Approx(0.5 * mm_per_s));
  CHECK(*planes[1].slowed_by == 2);
  dynamics.axes.resize(1);
  auto const alone = pass_corner(dynamics, {.turn = pi / 2, .feed = 1000});
  REQUIRE(alone.size() == 1);
  CHECK(alone[0].velocity == Approx(2 * mm_per_s));
  CHECK(*alone[0].slowed_by == 0);
}

}  // namespace axisc::motion::corner_passage_test
