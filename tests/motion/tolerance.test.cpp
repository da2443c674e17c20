// Tolerance monitoring: the largest axis error equals the tolerance, and nothing is slower than it must be.
#include "channels.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

namespace axisc::motion {
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

}  // namespace axisc::motion
