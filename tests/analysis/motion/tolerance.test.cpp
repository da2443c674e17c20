// Tolerance monitoring: no axis error exceeds the tolerance, and nothing is slower than it must be.
#include "analysis/motion/interpolator.hpp"
#include "analysis/motion/look_ahead.hpp"
#include "channels.hpp"
#include "plain_geometry.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

namespace axisc::motion::tolerance_test {
namespace {

using design::KernelSpecification;
using design::KernelType;
using test::channel_of;
using test::per_cycle;
using test::simulated;

double largest(PathSummary const& summary) {
  return *std::max_element(summary.axis_error.begin(), summary.axis_error.end());
}

std::string polygon(int corners, double side_mm, double angle) {
  std::string text;
  double x = 0;
  double y = 0;
  for (int i = 0; i < corners; ++i) {
    double const direction = angle + 2 * std::numbers::pi * i / corners;
    x += side_mm * std::cos(direction);
    y += side_mm * std::sin(direction);
    text += fmt::format("G01 X{:.6f} Y{:.6f}\n", x, y);
  }
  return text;
}

std::string square() {
  return "G01 X0 Y1 F4000\nG01 X1 Y1\nG01 X1 Y0\nG01 X0 Y0\n";
}

}  // namespace

namespace {

struct Random {
  std::mt19937_64 engine;

  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11U) * 0x1p-53;
  }
  double logarithmic(double low, double high) { return low * std::pow(high / low, number(0, 1)); }
  int whole(int low, int high) {
    return low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1));
  }
};

/// Two corners of opposite turn with a short block between them, polylines, circles and helices in chords,
/// short blocks, ways back: end points in mm.
std::vector<test::Place> random_contour(Random& random, int kind) {
  std::vector<test::Place> points = {{0, 0, 0}};
  double direction = random.number(0, 6);
  auto const go = [&](double length, double turn) {
    direction += turn;
    auto const& from = points.back();
    points.push_back({from[0] + length * std::cos(direction), from[1] + length * std::sin(direction), 0});
  };
  switch (kind) {
    case 0: {
      double const turn = random.number(0.2, 1.5) * (random.whole(0, 1) == 0 ? 1 : -1);
      go(random.number(1, 6), 0);
      go(random.logarithmic(0.002, 0.5), turn);
      go(random.number(1, 6), -turn * random.number(0.5, 1.5));
      break;
    }
    case 1:
      for (int i = random.whole(3, 6); i > 0; --i) go(random.number(0.5, 5), random.number(-2, 2));
      break;
    case 2:
    case 3: {
      double const radius = random.logarithmic(0.5, 5);
      double const chord = random.logarithmic(0.05, 0.5);
      double const step = chord / radius;
      int const chords = std::min(60, static_cast<int>(4 / step));
      for (int i = 1; i <= chords; ++i) {
        points.push_back({radius * std::sin(i * step), radius * (1 - std::cos(i * step)),
                          kind == 2 ? 0 : 0.05 * i * random.number(0.99, 1.01)});
      }
      break;
    }
    case 4: {
      double const size = random.logarithmic(0.005, 0.2);
      int const blocks = random.whole(20, 60);
      for (int i = 0; i < blocks; ++i) go(random.number(0.1, 1) * size, random.number(-0.4, 0.4));
      break;
    }
    default:
      go(random.number(1, 4), 0);
      go(random.logarithmic(0.01, 2), std::numbers::pi);
      go(random.number(0.5, 3), random.number(-1, 1));
      break;
  }
  for (auto& point : points) {
    for (auto& x : point) x = std::round(x * 1e5) / 1e5;
  }
  return points;
}

std::string blocks_of(std::vector<test::Place> const& contour) {
  std::string text;
  for (std::size_t i = 1; i < contour.size(); ++i) {
    text += fmt::format("X{:.5f} Y{:.5f} Z{:.5f}\n", contour[i][0], contour[i][1], contour[i][2]);
  }
  return text;
}

std::vector<test::Place> setpoints_of(test::Recorded const& found) {
  std::vector<test::Place> setpoints;
  for (auto const& cycle : found.cycles) {
    auto const& nominal = cycle.point.point.nominal;
    setpoints.push_back({nominal[0], nominal[1], nominal[2]});
  }
  return setpoints;
}

/// In position units, without points that a program's blocks of length 0 repeat.
std::vector<test::Place> in_units(std::vector<test::Place> contour) {
  for (auto& point : contour) {
    for (auto& x : point) x *= 1e4;
  }
  contour.erase(std::unique(contour.begin(), contour.end()), contour.end());
  return contour;
}

void keep_on_random_paths(int rounds) {
  for (int round = 0; round < rounds; ++round) {
    Random random{std::mt19937_64(static_cast<unsigned>(round))};
    double const seconds = random.whole(1, 8) * 0.0005;
    design::CycleTime const cycle_time{static_cast<std::uint32_t>(std::lround(seconds * 1e9))};
    int const order = random.whole(2, round % 4 == 0 ? 160 : 60);
    KernelSpecification kernel{.order = static_cast<std::uint32_t>(order)};
    auto taps = test::average_taps(order);
    if (round % 3 == 1) {
      kernel.type = KernelType::gaussian;
      taps = test::gaussian_taps(order);
    } else if (round % 3 == 2) {
      kernel.type = KernelType::windowed_sinc;
      kernel.frequency = {40};
      taps = test::sinc_taps(order, 40, seconds);
    }
    auto machine = channel_of({kernel, kernel, kernel}, cycle_time);
    for (auto& axis : machine.axes) {
      axis.acceleration_limit = random.logarithmic(1000, 30'000);
      axis.transition_weight = random.whole(0, 1) * 500;
    }
    auto const contour = random_contour(random, round % 6);
    auto const program = fmt::format("G01 F{:.0f}\n", random.logarithmic(500, 20'000)) + blocks_of(contour);
    double const free = largest(simulated(machine, program).passes.at(0));
    if (free < 1) continue;
    double const tolerance_mm = std::max(1e-5, std::round(free * random.logarithmic(0.03, 1.1) * 10) / 1e5);
    auto const monitored = fmt::format("#FILTER ON [AX_DEV={:.5f}]\n", tolerance_mm) + program;
    auto const found = simulated(machine, monitored);
    INFO(round << ", " << seconds << " s, order " << order << ", free " << free << "\n" << monitored);
    CHECK(largest(found.passes.at(0)) <= tolerance_mm * 1e4);
    auto const measured =
        test::largest_of(test::distances(in_units(contour), setpoints_of(found), {taps, taps, taps}));
    CHECK(measured.largest() <= tolerance_mm * 1e4 * (1 + 1e-9));
  }
}

}  // namespace

TEST_CASE("no axis error of any path exceeds the tolerance") {
  keep_on_random_paths(test::sanitized ? 15 : 100);
}

TEST_CASE("no axis error of a thousand paths exceeds the tolerance", "[.][long]") {
  keep_on_random_paths(1000);
}

TEST_CASE("the manual's square in three passes") {
  auto const found = simulated(channel_of({{.order = 40}, {.order = 40}}),
                               "G00 G90 X0 Y0\n#FILTER ON [AX_DEV=0.001]\n" + square() + "#FILTER ON\n" +
                                   square() + "#FILTER OFF\n" + square() + "M30\n");
  REQUIRE(found.passes.size() == 3);
  auto const& [monitored, filtered, plain] = std::tie(found.passes[0], found.passes[1], found.passes[2]);
  CHECK(largest(monitored) <= 10);
  CHECK(largest(monitored) >= 9.5);
  CHECK(largest(filtered) > 10);
  CHECK(largest(plain) == 0);
  CHECK(monitored.cycles > filtered.cycles);
  CHECK(filtered.cycles > plain.cycles);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(largest(found.blocks[i]) <= 10);
    CHECK(largest(found.blocks[i]) >= 9.5);
  }
}

TEST_CASE("a plateau around each corner, and the old velocity everywhere else") {
  auto const with =
      simulated(channel_of({{.order = 40}, {.order = 40}}), "#FILTER ON [AX_DEV=0.01]\nG01 X30 F6000\nY30\n");
  auto const without = simulated(channel_of({{.order = 40}, {.order = 40}}), "G01 X30 F6000\nY30\n");
  // e = v T h (h + 1) / (2 (2 h + 1)) = 10 µm
  double const plateau = 100 * (2 * 41) / (20 * 21.0);
  double lowest = 1e9;
  std::size_t on_plateau = 0;
  for (auto const& cycle : with.cycles) {
    auto const& point = cycle.point.point;
    double const from_corner = std::hypot(point.nominal[0] - 3e5, point.nominal[1]);
    // Ramps of 10 m/s² between plateau and feed: v²/2a, in units and cycles.
    double const ramp = (1000.0 * 1000.0 - plateau * plateau) / (2 * 100) + 1000;
    if (from_corner > ramp + plateau * 22 && point.nominal[0] > 6000 && point.nominal[1] < 2.94e5) {
      CHECK(point.velocity == Approx(per_cycle(6000)));
    }
    if (from_corner < 1e4) lowest = std::min(lowest, point.velocity);
    if (from_corner < plateau * 20.9) on_plateau += std::abs(point.velocity - lowest) < 1e-6 ? 1 : 0;
  }
  CHECK(lowest == Approx(plateau).epsilon(0.03));
  CHECK(lowest <= plateau);
  CHECK(on_plateau >= 40);
  CHECK(on_plateau <= 44);
  CHECK(with.passes.at(0).cycles > without.passes.at(0).cycles);
}

TEST_CASE("polygons of any corners, feeds, tolerances, cycle times and kernels") {
  std::mt19937_64 engine(7);
  auto const number = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11U) * 0x1p-53;
  };
  for (int round = 0; round < 60; ++round) {
    int const corners = 3 + round % 6;
    double const tolerance = std::pow(10, number(-4, -2));
    design::CycleTime const cycle_time{static_cast<std::uint32_t>(1000 * std::round(number(250, 4000)))};
    KernelSpecification const kernel{
        .type = round % 2 == 0 ? KernelType::moving_average : KernelType::gaussian,
        .order = static_cast<std::uint32_t>(number(20, 120))};
    auto machine = channel_of({kernel, kernel}, cycle_time);
    for (auto& axis : machine.axes) axis.acceleration_limit = number(2000, 50'000);
    std::string const program =
        fmt::format("#FILTER ON [AX_DEV={:.6f}]\nG01 F{:.1f}\n", tolerance, number(1000, 30'000)) +
        polygon(corners, number(20, 60), number(0, 6));
    auto const found = simulated(machine, program);
    INFO(program << cycle_time.nanoseconds << " order " << kernel.order);
    double const error = largest(found.passes.at(0));
    CHECK(error <= tolerance * 1e4 * (1 + 1e-9));
    CHECK(error >= tolerance * 1e4 * 0.95);
  }
}

TEST_CASE("a corner that keeps the tolerance anyway is not slowed down") {
  std::string const path = "G01 X5 F3000\nX10 Y0.01\nX15 Y0.05\n";
  auto const with = simulated(channel_of({{.order = 20}, {.order = 20}}), "#FILTER ON [AX_DEV=0.1]\n" + path);
  auto const without = simulated(channel_of({{.order = 20}, {.order = 20}}), path);
  CHECK(with.passes.at(0).cycles == without.passes.at(0).cycles);
  CHECK(largest(with.passes.at(0)) == Approx(largest(without.passes.at(0))));
}

TEST_CASE("curvature in short blocks keeps the tolerance") {
  std::string program = "#FILTER ON [AX_DEV=0.005]\nG01 F10000 X5 Y0\n";
  for (int i = 1; i <= 400; ++i) {
    double const angle = 2 * std::numbers::pi * i / 400;
    program += fmt::format("X{:.5f} Y{:.5f}\n", 5 * std::cos(angle), 5 * std::sin(angle));
  }
  auto machine = channel_of({{.order = 100}, {.order = 100}});
  for (auto& axis : machine.axes) axis.acceleration_limit = 1e6;
  auto const found = simulated(machine, program);
  CHECK(largest(found.passes.at(0)) <= 50 * 1.001);
  // Away from the first corner the circle itself governs: the polygon's radius shrinks by the tolerance.
  double on_circle = 0;
  for (std::size_t i = 100; i < 300; ++i) on_circle = std::max(on_circle, largest(found.blocks[i]));
  CHECK(on_circle >= 45);
}

TEST_CASE("a tolerance that nothing exceeds changes nothing") {
  auto const machine = channel_of({{.order = 40}, {.order = 40}});
  auto const without = simulated(machine, "#FILTER ON\n" + square());
  auto const taps = test::average_taps(40);
  std::vector<test::Place> const contour = {{0, 0}, {0, 1e4}, {1e4, 1e4}, {1e4, 0}, {0, 0}};
  double const free =
      test::largest_of(test::distances(contour, setpoints_of(without), {taps, taps}, 7)).largest();
  for (double const share : {1.005, 1.4}) {
    auto const with =
        simulated(machine, fmt::format("#FILTER ON [AX_DEV={:.5f}]\n", free * share / 1e4) + square());
    REQUIRE(with.cycles.size() == without.cycles.size());
    bool equal = true;
    for (std::size_t n = 0; n < with.cycles.size(); ++n) {
      equal = equal && with.cycles[n].point.point.nominal == without.cycles[n].point.point.nominal;
    }
    CHECK(equal);
  }
}

TEST_CASE("corners that the axes' limits slow down anyway are slowed no further than the tolerance asks") {
  // Between 130 and 259 µm the corner's own velocity is below the plateau's: what counts is how fast the path
  // leaves it.
  auto const machine = channel_of({{.order = 40}, {.order = 40}});
  double time = 1e9;
  for (double const tolerance : {0.05, 0.15, 0.17, 0.2, 0.25, 0.259}) {
    auto const found = simulated(machine, fmt::format("#FILTER ON [AX_DEV={:.3f}]\n", tolerance) + square());
    INFO(tolerance);
    CHECK(largest(found.passes.at(0)) <= tolerance * 1e4);
    CHECK(largest(found.passes.at(0)) >= tolerance * 1e4 * 0.97);
    CHECK(found.passes.at(0).cycles <= time);
    time = found.passes.at(0).cycles;
  }
}

TEST_CASE("what bends a straight line keeps the tolerance, too") {
  // Delays 20 cycles apart: v ΔD / 2 at constant velocity.
  auto const machine = channel_of({{.order = 60}, {.order = 20}});
  auto const found = simulated(machine, "#FILTER ON [AX_DEV=0.1]\nG01 X30 Y30 F6000\nX30 Y60\n");
  CHECK(largest(found.passes.at(0)) <= 1000);
  CHECK(largest(found.passes.at(0)) >= 970);
  auto const measured =
      test::largest_of(test::distances({{0, 0}, {3e5, 3e5}, {3e5, 6e5}}, setpoints_of(found),
                                       {test::average_taps(60), test::average_taps(20)}));
  CHECK(measured.largest() <= 1000 * (1 + 1e-9));
}

namespace {

/// Setpoints of a planned path.
struct Setpoints final : SampleSink {
  void sample(Point const& setpoint, double /*velocity*/, PathBlock const& /*block*/) override {
    all.push_back({setpoint[0], setpoint[1], setpoint[2]});
  }
  void corner(PathBlock const&, PathBlock const*, double, BlockMotion const&) override {}
  std::vector<test::Place> all;
};

}  // namespace

TEST_CASE("the tolerance is kept across the planner's windows, too") {
  int constexpr order = 30;
  auto const machine = channel_of({{.order = order}, {.order = order}, {.order = order}});
  auto const taps = test::average_taps(order);
  auto const answers = test::answers_of(machine);
  for (int round = 0; round < (test::sanitized ? 4 : 20); ++round) {
    Random random{std::mt19937_64(static_cast<unsigned>(round))};
    std::vector<test::Place> contour = {{0, 0, 0}};
    for (int part = 0; part < 4; ++part) {
      auto const piece = random_contour(random, random.whole(0, 5));
      auto const from = contour.back();
      for (std::size_t i = 1; i < piece.size(); ++i) {
        contour.push_back({from[0] + piece[i][0], from[1] + piece[i][1], from[2] + piece[i][2]});
      }
    }
    contour = in_units(contour);
    auto probe = test::runtime_of(machine);
    Setpoints setpoints;
    Interpolator interpolator(setpoints);
    PathDynamics dynamics;
    // 5000 units per cycle of 1 ms are 500 mm/s, 10 units per cycle² 1000 mm/s².
    dynamics.axes.assign(3, test::step_axis(500'000, random.logarithmic(1000, 20'000)));
    dynamics.channel.look_ahead_blocks = static_cast<std::uint32_t>(random.whole(4, 24));
    LookAhead look_ahead(PathLimits(dynamics), false, interpolator);
    double const tolerance = random.logarithmic(3, 100);
    look_ahead.begin({}, ToleranceMonitor(probe, answers, tolerance), 1);
    double const feed = random.logarithmic(100, 3000);
    for (std::size_t i = 1; i < contour.size(); ++i) {
      ProgrammedBlock block;
      std::copy(contour[i].begin(), contour[i].end(), block.end.begin());
      block.feed = feed;
      look_ahead.add(block);
    }
    look_ahead.stop();
    INFO(round);
    auto const measured = test::largest_of(test::distances(contour, setpoints.all, {taps, taps, taps}));
    CHECK(measured.largest() <= tolerance * (1 + 1e-9));
  }
}

TEST_CASE("a pass says that it exceeds its tolerance where the machine does not do what was planned for") {
  // Planned is for kernels of order 4; those of the machine are longer.
  test::Recorded recorded;
  PathDynamics dynamics;
  dynamics.axes.assign(2, test::step_axis(500'000, 10'000));
  Simulation simulation(test::runtime_of(channel_of({{.order = 60}, {.order = 60}})),
                        test::runtime_of(channel_of({{.order = 4}, {.order = 4}})), PathLimits(dynamics),
                        false, recorded);
  FilterChange change;
  change.command.filter_switch = machine::FilterSwitch::on;
  change.tolerance = 10;
  simulation.command(change);
  for (Point const& end : {Point{10'000}, Point{10'000, 10'000}}) {
    ProgrammedBlock block;
    block.end = end;
    block.feed = 1000;
    simulation.motion(block);
  }
  simulation.end();
  REQUIRE_FALSE(simulation.failure().has_value());
  REQUIRE(recorded.passes.size() == 1);
  CHECK(recorded.passes[0].tolerance == 10);
  CHECK_FALSE(recorded.passes[0].keeps_tolerance());
}

}  // namespace axisc::motion::tolerance_test
