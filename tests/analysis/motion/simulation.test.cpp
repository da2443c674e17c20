#include "analysis/motion/simulation.hpp"

#include "channels.hpp"
#include "plain_geometry.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <random>

#include <fmt/format.h>

namespace axisc::motion::simulation_test {
namespace {

using test::channel_of;
using test::per_cycle;
using test::simulated;

/// Fails where an axis exceeds its velocity, or where its velocity changes by more than `steps` accelerations
/// a cycle.
void check_limits(test::Recorded const& found, std::size_t axes, double velocity, double acceleration,
                  double steps) {
  Point before{};
  Point change_before{};
  for (auto const& cycle : found.cycles) {
    Point const change = minus(cycle.point.point.nominal, before);
    for (std::size_t i = 0; i < axes; ++i) {
      CHECK(std::abs(change[i]) <= velocity * (1 + 1e-9) + 1e-6);
      CHECK(std::abs(change[i] - change_before[i]) <= steps * acceleration * (1 + 1e-6) + 1e-6);
    }
    before = cycle.point.point.nominal;
    change_before = change;
  }
}

std::vector<test::Place> setpoints_of(test::Recorded const& found) {
  std::vector<test::Place> setpoints;
  for (auto const& cycle : found.cycles) {
    auto const& nominal = cycle.point.point.nominal;
    setpoints.push_back({nominal[0], nominal[1], nominal[2]});
  }
  return setpoints;
}

/// Compares every block's figures with plain geometry along this contour; kernels are those of the axes.
void check_geometry(test::Recorded const& found, std::vector<test::Place> const& contour,
                    std::vector<std::vector<double>> const& taps, double within = 0.01) {
  // Between two setpoints a simulation does not look.
  auto const expected = test::distances(contour, setpoints_of(found), taps, 0);
  REQUIRE(found.blocks.size() == expected.size());
  for (std::size_t block = 0; block < expected.size(); ++block) {
    INFO("block " << block);
    CHECK(found.blocks[block].deviation == Approx(expected[block].deviation).epsilon(within).margin(0.01));
    for (std::size_t i = 0; i < taps.size(); ++i) {
      CHECK(found.blocks[block].axis_error[i] ==
            Approx(expected[block].axis_error[i]).epsilon(within).margin(0.01));
    }
  }
}

design::KernelSpecification delay_of(std::uint32_t cycles) {
  return {.type = design::KernelType::time_delay, .order = cycles};
}

std::string const corners = "G01 X10 F10000\nY10\nX0\n";
std::vector<test::Place> const corners_contour = {{0, 0}, {1e5, 0}, {1e5, 1e5}, {0, 1e5}};

}  // namespace

TEST_CASE("filters that only delay, all axes alike, make no error") {
  for (std::uint32_t const cycles : {2U, 10U, 54U, 100U}) {
    for (bool const constant_velocity : {false, true}) {
      auto const found =
          simulated(channel_of({delay_of(cycles), delay_of(cycles)}), corners, constant_velocity);
      for (auto const& block : found.blocks) CHECK(block.deviation < 1e-6);
    }
  }
}

TEST_CASE("a delay that is longer than the rest of the chain reaches") {
  SECTION("with a moving average") {
    auto machine = channel_of({{.order = 4}, {.order = 4}});
    for (auto& axis : machine.axes) {
      axis.filters.push_back(
          {.index = 0, .specification = {.type = design::FilterType::time_delay, .time_constant = {5000}}});
    }
    auto const taps = test::in_series(test::delay_taps(5), test::average_taps(4));
    check_geometry(simulated(machine, corners), corners_contour, {taps, taps});
  }
  SECTION("with a PT1") {
    auto machine = channel_of({delay_of(100), delay_of(100)});
    for (auto& axis : machine.axes) {
      axis.filters.push_back(
          {.index = 0, .specification = {.type = design::FilterType::pt1, .time_constant = {3000}}});
    }
    auto const taps = test::in_series(test::delay_taps(100), test::pt1_taps(3000, 0.001));
    check_geometry(simulated(machine, corners), corners_contour, {taps, taps});
  }
}

TEST_CASE("axes that delay differently leave the corner") {
  // 10000 mm/min are 1666.67 units per cycle; the corner lies on a cycle, in the middle of one, and off it.
  for (double const x_mm : {10.0, 10.0833, 10.0417}) {
    auto const found = simulated(channel_of({delay_of(51), delay_of(50)}),
                                 fmt::format("G01 X{:.4f} F10000\nY10\n", x_mm), true);
    double const x = std::round(x_mm * 1e4);
    check_geometry(found, {{0, 0}, {x, 0}, {x, 1e5}}, {test::delay_taps(51), test::delay_taps(50)}, 1e-6);
  }
}

TEST_CASE("constant path velocity: the corner's error is the predicted one") {
  auto const found =
      simulated(channel_of({{.order = 40}, {.order = 40}}), "G91 G01 F1000 X10\nY10\nX-10\nY-10\n", true);
  double const expected = per_cycle(1000) * 20 * 21 / (2 * 41);
  REQUIRE(found.blocks.size() == 4);
  for (auto const& block : found.blocks) {
    CHECK(block.axis_error[0] == Approx(expected).epsilon(0.005));
    CHECK(block.axis_error[1] == Approx(expected).epsilon(0.005));
    CHECK(block.deviation == Approx(std::sqrt(2) * expected).epsilon(0.005));
    CHECK(block.cycles == Approx(600));
  }
}

TEST_CASE("identical filters leave straight lines straight") {
  auto const found =
      simulated(channel_of({{.order = 60}, {.order = 60}, {.order = 60}}), "G01 X30 Y-17 Z5 F20000\n");
  REQUIRE(found.passes.size() == 1);
  CHECK(found.passes[0].deviation < 0.01);
  CHECK(found.passes[0].lag > 100);
}

TEST_CASE("different filters bend them") {
  auto const found = simulated(channel_of({{.order = 60}, {.order = 20}}), "G01 X30 Y30 F6000\n");
  // v ΔD / 2 at constant velocity, ΔD = 20 cycles
  CHECK(found.passes.at(0).deviation == Approx(per_cycle(6000) * 20 / 2).epsilon(0.01));
}

TEST_CASE("without filter the path is the programmed one") {
  auto const found = simulated(channel_of({{.order = 0}, {.order = 0}}), "G01 X3 F5000\nY1\nX0\nY0\n");
  REQUIRE(found.passes.size() == 1);
  CHECK(found.passes[0].deviation == 0);
  CHECK(found.passes[0].axis_error == Point{});
}

TEST_CASE("planned paths keep the axes' limits and end where they should") {
  std::mt19937_64 engine(20261121);
  auto const number = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11U) * 0x1p-53;
  };
  for (int round = 0; round < 20; ++round) {
    std::string program = fmt::format("G01 F{:.3f}\n", number(500, 40'000));
    double x = 0;
    double y = 0;
    for (int block = 0; block < 300; ++block) {
      double const size = std::pow(10, number(-3, 1));
      x += number(-size, size);
      y += number(-size, size);
      program += fmt::format("X{:.4f} Y{:.4f}\n", x, y);
    }
    auto const found = simulated(channel_of({{.order = 4}, {.order = 4}}), program);
    // Inside a cycle a path may leave one corner, accelerate and meet the next one: each takes its share of
    // the cycle.
    check_limits(found, 2, 500 * 10, 100, 4);
    auto const& last = found.cycles.back().point;
    CHECK(last.point.nominal[0] == Approx(std::round(x * 1e4)).margin(1e-6));
    CHECK(last.filtered[1] == Approx(std::round(y * 1e4)).margin(1e-6));
    CHECK(found.blocks.size() <= 300);
  }
}

TEST_CASE("a straight path in many blocks takes as long as in one") {
  // 28000 mm/min and 10 m/s² brake within 10.9 mm, which are fewer blocks than the 120 that the control
  // knows.
  std::string program = "G01 F28000\n";
  for (int i = 1; i <= 5000; ++i) program += fmt::format("X{:.2f}\n", i * 0.1);
  auto const pieces = simulated(channel_of({{.order = 10}}), program);
  auto const whole = simulated(channel_of({{.order = 10}}), "G01 X500 F28000\n");
  CHECK(pieces.passes.at(0).cycles == Approx(whole.passes.at(0).cycles).margin(1));
}

TEST_CASE("kernels change at rest, between passes") {
  auto const found = simulated(channel_of({{.order = 40}, {.order = 40}}),
                               "G01 X5 F3000\nY5\n#FILTER ON [ORDER=10]\nX0\nY0\n#FILTER OFF\nX5\nY5\n");
  REQUIRE(found.passes.size() == 3);
  CHECK(found.passes[0].axis_error[0] > found.passes[1].axis_error[0]);
  CHECK(found.passes[1].axis_error[0] > 0);
  CHECK(found.passes[2].axis_error[0] == 0);
  CHECK(found.passes[1].command == "#FILTER ON [ORDER=10]");
}

TEST_CASE("a command without ON keeps the tolerance and the order of those before it") {
  std::string const path = "G01 X5 F6000\nY5\nX0\nY0\n";
  auto const found = simulated(channel_of({{.order = 40}, {.order = 40}}),
                               "#FILTER ON [AX_DEV=0.002 ORDER=60]\n" + path + "#FILTER [SHARE=90]\n" + path +
                                   "#FILTER [AX_DEV=0]\n" + path + "#FILTER ON [ORDER=60 SHARE=90]\n" + path +
                                   "#FILTER ON [AX_DEV=0.002]\n" + path + "#FILTER ON\n" + path);
  REQUIRE(found.passes.size() == 6);
  for (std::size_t const pass : {0U, 1U, 4U}) {
    CHECK(found.passes[pass].axis_error[0] <= 20);
    CHECK(found.passes[pass].axis_error[0] > 19);
  }
  CHECK(found.passes[2].axis_error[0] > 200);
  CHECK(found.passes[3].axis_error[0] == found.passes[2].axis_error[0]);
  CHECK(found.passes[3].cycles == found.passes[2].cycles);
  CHECK(found.passes[5].axis_error[0] > 100);
  CHECK(found.passes[5].axis_error[0] < found.passes[3].axis_error[0]);
}

TEST_CASE("a command without ON keeps the acceleration of corners") {
  auto machine = channel_of({{.order = 4}, {.order = 4}});
  for (auto& axis : machine.axes) axis.transition_weight = 500;
  // STEP knows no transition weights.
  std::string const path = "#SLOPE [TYPE=TRAPEZ]\nG01 X5 F6000\nY5\nX0\nY0\n";
  auto const found =
      simulated(std::move(machine), "#FILTER ON [ACC_FACT=10]\n" + path + "#FILTER [SHARE=100]\n" + path +
                                        "#FILTER ON [SHARE=100]\n" + path);
  REQUIRE(found.passes.size() == 3);
  CHECK(found.passes[1].cycles == found.passes[0].cycles);
  CHECK(found.passes[2].cycles > found.passes[0].cycles);
}

/// 10 mm out along X and 10 along Y, with an exact stop between them.
test::Recorded with_exact_stop(machine::Machine const& machine, double window) {
  auto path = test::path_of(machine);
  for (auto& axis : path.axes) axis.exact_stop_window = window;
  test::Recorded recorded;
  Simulation simulation(test::runtime_of(machine), test::runtime_of(machine), PathLimits(path), false,
                        recorded);
  for (Point const& end : {Point{1e5}, Point{1e5, 1e5}}) {
    ProgrammedBlock block;
    block.end = end;
    block.feed = per_cycle(6000);
    block.exact_stop = end[1] == 0;
    simulation.motion(block);
  }
  simulation.end();
  CHECK_FALSE(simulation.failure().has_value());
  return recorded;
}

TEST_CASE("an exact stop waits until the filtered position is within the window of each axis") {
  // 100 mm/s and 10 m/s²: 110 cycles a block. A moving average of 41 cycles rests 40 cycles after its
  // setpoint, and the pass ends when it does.
  auto const machine = channel_of({{.order = 40}, {.order = 40}});
  CHECK(with_exact_stop(machine, 0.5).passes.at(0).cycles == 110 + 40 + 110 + 40);
  // The setpoint has the way v²/2a = 5000 units left when it begins to brake, and d cycles before its end 50
  // d². Of 41 taps those that lie m and fewer cycles back are at the end: what is left is the sum of 50 d²
  // over the others / 41.
  double const window = 500;
  int wait = 0;
  for (;; ++wait) {
    double left = 0;
    for (int age = 0; age <= 40; ++age) {
      int const d = age - wait;
      // Before braking, which takes 10 cycles, the setpoint moves by 1000 units a cycle.
      if (d > 0) left += d <= 10 ? 50.0 * d * d : 5000 + 1000.0 * (d - 10);
    }
    if (left / 41 <= window) break;
  }
  REQUIRE(wait > 0);
  REQUIRE(wait < 40);
  CHECK(with_exact_stop(machine, window).passes.at(0).cycles == 110 + wait + 110 + 40);
  // Without filters it is there at once; nothing of the corner is left.
  CHECK(with_exact_stop(channel_of({{.order = 0}, {.order = 0}}), window).passes.at(0).cycles == 220);
}

TEST_CASE("a pass has the largest accelerations and jerks of its axes") {
  // 3-4-5 with ramps of 50 ms up to 500 mm/s: a = 10/0.8 m/s² along, jerk a/tr; STEP has no jerk to name.
  auto machine = channel_of({{.order = 0}, {.order = 0}});
  std::string const move = "G01 X300 Y400 F30000\n";
  auto const step = simulated(machine, move).passes.at(0).peaks;
  CHECK(step.acceleration[0] == Approx(75));
  CHECK(step.acceleration[1] == Approx(100));
  CHECK(step.jumps);
  machine.groups[0].dynamics.slope = machine::Slope::trapez;
  auto const found = simulated(machine, move);
  auto const& trapez = found.passes.at(0).peaks;
  // Δ = 500 is less than a t̄/2 = 625 mm/s: q = √0.8.
  CHECK(trapez.acceleration[1] == Approx(100 * std::sqrt(0.8)));
  CHECK(trapez.jerk[1] == Approx(100.0 / 50));
  CHECK(trapez.jerk[0] == Approx(75.0 / 50));
  CHECK_FALSE(trapez.jumps);
  CHECK(found.blocks.at(0).motion.velocity_peak == Approx(5000));
  CHECK(found.blocks[0].slope == machine::Slope::trapez);
  // On a circle of 20 mm at 100 mm/s: 500 mm/s² across, and 10 m/s² along, at right angles.
  machine.groups[0].dynamics.slope = machine::Slope::step;
  auto const circle = simulated(machine, "G02 I20 F6000\n").passes.at(0).peaks;
  CHECK(circle.acceleration[0] == Approx(100).epsilon(1e-3));
  CHECK(circle.acceleration[1] == Approx(circle.acceleration[0]));
}

TEST_CASE("a block says that AX_DEV limits it") {
  auto const found = simulated(channel_of({{.order = 40}, {.order = 40}}),
                               "#FILTER ON [AX_DEV=0.002]\nG01 X10 F6000\nY10\n");
  CHECK(found.blocks.at(0).motion.limited_by == LimitedBy::tolerance);
  CHECK(found.blocks[0].motion.velocity_out < per_cycle(6000) / 2);
}

TEST_CASE("HSC has the time of TRAPEZ beside it") {
  // Ten blocks of 2 mm, 2 m/s², 50 ms: 371.564 and 300 cycles; setpoints of the end come with the next cycle.
  auto machine = channel_of({{.order = 0}, {.order = 0}});
  for (auto& axis : machine.axes) axis.acceleration_limit = 2000;
  machine.groups[0].dynamics.slope = machine::Slope::hsc;
  std::string program = "G01 F6000\n";
  for (int i = 1; i <= 10; ++i) program += fmt::format("X{}\n", 2 * i);
  auto const found = simulated(machine, program).passes.at(0);
  CHECK(found.cycles == Approx(300).margin(1));
  REQUIRE(found.trapez_cycles.has_value());
  CHECK(*found.trapez_cycles - found.cycles == Approx(71.564023));
  machine.groups[0].dynamics.slope = machine::Slope::trapez;
  CHECK_FALSE(simulated(machine, program).passes.at(0).trapez_cycles.has_value());
}

TEST_CASE("a least velocity through corners says how far it exceeds the axes' steps") {
  // STEP: 10 m/s² are 10 mm/s in a cycle; 15 mm/s at 90° are 1.5 times as much.
  auto const machine = channel_of({{.order = 0}, {.order = 0}});
  for (auto const& [least, share] : {std::pair{15.0, 1.5}, std::pair{5.0, 0.0}}) {
    test::Recorded recorded;
    Simulation simulation(test::runtime_of(machine), test::runtime_of(machine),
                          PathLimits(test::path_of(machine)), false, recorded);
    BlockDynamics words;
    words.least_corner_velocity = least;
    auto const said = std::make_shared<BlockDynamics const>(words);
    for (Point const& end : {Point{1e5}, Point{1e5, 1e5}}) {
      ProgrammedBlock block;
      block.end = end;
      block.feed = per_cycle(6000);
      block.dynamics = said;
      simulation.motion(block);
    }
    simulation.end();
    REQUIRE(recorded.blocks.size() == 2);
    CHECK(recorded.blocks[0].corner_step_share.value_or(0) == Approx(share));
    CHECK_FALSE(recorded.blocks[1].corner_step_share.has_value());
  }
}

}  // namespace axisc::motion::simulation_test
