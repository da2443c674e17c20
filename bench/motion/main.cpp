// How long the planner takes for a million blocks of each slope, without sampling (processor time):
// bench_motion [BLOCKS].
#include "analysis/motion/look_ahead.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace axisc {
namespace {

using motion::Point;

/// Adds up the time of the path.
struct Clock final : motion::PathSink {
  double cycles = 0;
  std::size_t phases = 0;

  void piece(motion::PathBlock const&, motion::Phase const& phase) override {
    cycles += phase.duration;
    ++phases;
  }
  void block_end(motion::PathBlock const&, motion::PathBlock const*, motion::BlockMotion const&) override {}
  void rest(motion::PathBlock const&, std::uint64_t) override {}
  void exact_stop(motion::PathBlock const&) override {}
  [[nodiscard]] double room() const override { return std::numeric_limits<double>::infinity(); }
};

using motion::ProgrammedBlock;
constexpr double pi = 3.141592653589793;

/// Block n, without its feed.
using Curve = std::function<ProgrammedBlock(std::size_t)>;

ProgrammedBlock line_to(Point end) {
  for (auto& x : end) x *= motion::units_per_mm;
  ProgrammedBlock block;
  block.end = end;
  return block;
}

/// Straight blocks of 1 mm in any direction.
Curve lines() {
  return [engine = std::mt19937_64(1), at = Point{}](std::size_t) mutable {
    double const angle = static_cast<double>(engine() >> 11U) * 0x1p-53 * 2 * pi;
    at[0] += std::cos(angle);
    at[1] += std::sin(angle);
    return line_to(at);
  };
}

/// A free-form curve in blocks of this length.
Curve waves(double length) {
  return [length](std::size_t n) {
    double const x = length * static_cast<double>(n + 1);
    return line_to({x, 5 * std::sin(x / 10), std::cos(x / 7)});
  };
}

/// A meander of arcs of this many mm and degrees, each tangential to the one before it, on alternate sides;
/// with lines of 0.2 mm between them as tool paths have them.
Curve meander(double radius, double degrees, bool with_lines) {
  double const sweep = degrees * pi / 180;
  return [=, at = Point{}, heading = -sweep / 2, side = 1.0](std::size_t n) mutable {
    if (with_lines && n % 2 == 1) {
      at[0] += 0.2 * std::cos(heading);
      at[1] += 0.2 * std::sin(heading);
      return line_to(at);
    }
    double const phase = heading - side * pi / 2;
    double const center_x = at[0] - radius * std::cos(phase), center_y = at[1] - radius * std::sin(phase);
    heading += side * sweep;
    at[0] = center_x + radius * std::cos(phase + side * sweep);
    at[1] = center_y + radius * std::sin(phase + side * sweep);
    motion::Arc arc;
    arc.center_first = center_x * motion::units_per_mm;
    arc.center_second = center_y * motion::units_per_mm;
    arc.radius = radius * motion::units_per_mm;
    arc.phase = phase;
    arc.sweep = side * sweep;
    arc.length = arc.radius * sweep;
    side = -side;
    auto block = line_to(at);
    block.arc = std::make_shared<motion::Arc const>(arc);
    return block;
  };
}

double measure(Curve curve, machine::Slope slope, std::size_t blocks) {
  motion::PathDynamics dynamics;
  machine::AxisDynamics axis;
  axis.feed.velocity = 500'000;
  for (auto* const stages : {&axis.feed.step_up, &axis.feed.step_down})
    *stages = {.first = 2000, .second = 2000};
  for (auto* const ramp : {&axis.feed.up, &axis.feed.down}) {
    *ramp = {.acceleration = 2000, .build_up = 50'000, .take_back = 70'000};
  }
  axis.acceleration_transition_weight = 500;
  dynamics.axes.assign(3, axis);
  dynamics.channel.slope = slope;
  Clock clock;
  auto const begin = std::clock();
  motion::LookAhead planner(motion::PathLimits(dynamics), false, clock);
  planner.begin({}, {}, 1);
  for (std::size_t i = 0; i < blocks; ++i) {
    auto block = curve(i);
    block.feed = 1000;  // 6000 mm/min
    planner.add(block);
  }
  planner.stop();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace
}  // namespace axisc

int main(int count, char** words) {
  using axisc::machine::Slope;
  std::size_t const blocks = count > 1 ? std::strtoul(words[1], nullptr, 10) : 1'000'000;
  std::vector<std::pair<char const*, axisc::Curve>> const curves = {
      {"lines 1 mm", axisc::lines()},
      {"waves 0.5 mm", axisc::waves(0.5)},
      {"waves 0.05 mm", axisc::waves(0.05)},
      {"waves 0.01 mm", axisc::waves(0.01)},
      {"arcs 0.5 mm", axisc::meander(0.5, 60, false)},
      {"arcs 0.05 mm", axisc::meander(0.5, 6, false)},
      {"lines, arcs", axisc::meander(0.2, 90, true)},
      {"full circles", axisc::meander(0.5, 360, false)}};
  std::printf("%zu blocks, s  STEP  TRAPEZ  SIN2  HSC\n", blocks);
  for (auto const& [name, curve] : curves) {
    std::printf("%-14s", name);
    for (auto const slope : {Slope::step, Slope::trapez, Slope::sin2, Slope::hsc}) {
      std::printf("  %5.2f", axisc::measure(curve, slope, blocks));
      std::fflush(stdout);
    }
    std::printf("\n");
  }
}
