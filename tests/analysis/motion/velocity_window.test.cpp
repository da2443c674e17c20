// Which velocity a block may end with, as the known blocks become more.
#include "analysis/motion/planning/velocity_window.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace axisc::motion {
namespace {

/// Blocks of a path whose ramps outlive it.
struct RandomPath {
  std::vector<Ramp> ramps;
  std::vector<PathElement> elements;
};

/// Runs of alike blocks, so that some windows change with every block and others seldom.
RandomPath random_path(std::mt19937_64& engine, std::size_t count, RampRules const& rules) {
  auto const any = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(engine));
  };
  RandomPath path;
  path.ramps.reserve(2 * count);
  path.elements.resize(count);
  double length = 1;
  double corner = 1;
  for (auto& element : path.elements) {
    if (engine() % 20 == 0) {
      length = any(0.01, 3);
      corner = any(0.1, 10);
    }
    for (auto* const which : {&element.up, &element.down}) {
      RampTimes const times{.acceleration = any(0.009, 0.011), .at_slow_end = 50, .at_fast_end = 70};
      *which = &path.ramps.emplace_back(times, rules);
    }
    element.length = any(0.9, 1.1) * length;
    element.velocity = 1;
    element.entry = std::min(1.0, corner * any(0.5, 2));
  }
  return path;
}

/// The definition, without anything that makes it cheap: every window backwards from its end, and what a
/// shorter window allowed stays allowed.
class PlainWindows {
 public:
  explicit PlainWindows(std::vector<PathElement> const& elements)
      : elements_(elements), allowed_(elements.size(), -1) {}

  /// The most at the beginning of the block after `first`, when the control knows those before `end`.
  double after(std::size_t first, std::size_t end) {
    double next = 0;
    for (std::size_t i = end; i-- > first + 1;) {
      auto const& element = elements_[i];
      allowed_[i] =
          std::max(allowed_[i], std::min(element.entry, element.down->fastest(next, element.length)));
      next = allowed_[i];
    }
    return next;
  }

 private:
  std::vector<PathElement> const& elements_;
  std::vector<double> allowed_;
};

void check_window(RandomPath const& path, std::size_t window, std::size_t further) {
  VelocityWindow velocities;
  velocities.begin(0, false);
  PlainWindows plain(path.elements);
  std::size_t const count = path.elements.size();
  std::size_t pushed = 0;
  double velocity = 0;
  for (std::size_t n = 0; n < count; ++n) {
    while (pushed < std::min(count, n + window + further)) velocities.push(path.elements[pushed++]);
    std::size_t const end = std::min(count, n + window);
    auto const exit = exit_of(path.elements[n], velocity, plain.after(n, end));
    auto const passed = velocities.pass(end - n, n + window > count);
    INFO("block " << n << " of windows of " << window << ", further " << further);
    REQUIRE(passed.velocity_in == Approx(velocity).epsilon(1e-9));
    REQUIRE(passed.velocity_out == Approx(exit.velocity).epsilon(1e-9).margin(1e-12));
    REQUIRE(passed.is_possible == exit.is_possible);
    velocity = passed.velocity_out;
  }
}

}  // namespace

TEST_CASE("a window of the look-ahead is what its definition says, however many blocks are there already") {
  std::mt19937_64 engine(20260101);
  for (bool const sine : {false, true}) {
    for (std::size_t const window : {2U, 3U, 17U, 60U}) {
      auto const path = random_path(engine, 600, {.sine = sine});
      for (std::size_t const further : {0U, 1U, 2U, 3U}) check_window(path, window, further);
    }
  }
}

}  // namespace axisc::motion
