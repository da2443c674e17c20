// Axes whose motion is a polynomial of time, so that force and position are known in closed form. Simulated
// axes: axis_recordings.py.
#include "analysis/tuning/rigid_model/rigid_model.hpp"

#include "analysis/tuning/rigid_model/window.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace rigid_model_test {

using namespace axisc::tuning;

namespace {

constexpr double T = 1e-3;

/// x = D (10 u³ - 15 u⁴ + 6 u⁵), u = t / duration: from rest to rest.
struct Motion {
  double position = 0, velocity = 0, acceleration = 0, fourth = 0;
};
Motion quintic(double distance, double duration, double t) {
  double const u = t / duration;
  return {.position = distance * u * u * u * (10 + u * (-15 + 6 * u)),
          .velocity = distance / duration * 30 * u * u * (1 - u) * (1 - u),
          .acceleration = distance / std::pow(duration, 2) * 60 * u * (1 - u) * (1 - 2 * u),
          .fourth = distance / std::pow(duration, 4) * (720 * u - 360)};
}

struct Axis {
  double mass = 300, viscous = 200, coulomb = 90, constant = -40;
  double elastic = 0;         ///< m_M m_L / k, kg s²
  double resolution = 1e-7;   ///< m
  double position_noise = 0;  ///< m, half of the range
  double force_noise = 0.5;   ///< half of the range
  int dead_time = 0;          ///< samples
  bool is_one_way = false;
  std::size_t moves = 16;
  double longest = 0.3;  ///< s
};

double rounded(double value, double step) {
  return std::round(value / step) * step;
}

/// There and back at durations from a third of the longest one, with rests of 50 ms.
MotionRecord recorded(Axis const& axis) {
  std::mt19937 random(7);
  auto const uniform = [&] { return static_cast<double>(random()) / 4294967295.0; };
  MotionRecord record;
  double start = 0;
  for (std::size_t move = 0; move < axis.moves; ++move) {
    double const duration = axis.longest * (1 + 2 * uniform()) / 3;
    double const way = (0.3 + 0.7 * uniform()) * 0.05 * duration / axis.longest;
    double const distance = move % 2 == 0 || axis.is_one_way ? way : -way;
    auto const samples = static_cast<std::size_t>(duration / T);
    for (std::size_t k = 0; k < samples + 50; ++k) {
      bool const moves = k > 0 && k < samples;
      auto const now = moves ? quintic(distance, duration, static_cast<double>(k) * T)
                             : Motion{.position = k == 0 ? 0 : distance};
      double const friction = moves ? std::copysign(axis.coulomb, distance) : 0;
      double const noise = axis.position_noise * (2 * uniform() - 1);
      record.position.push_back(rounded(start + now.position + noise, axis.resolution));
      record.force.push_back(axis.mass * now.acceleration + axis.viscous * now.velocity + friction +
                             axis.constant + axis.elastic * now.fourth +
                             axis.force_noise * (2 * uniform() - 1));
    }
    start += distance;
  }
  for (int i = 0; i < axis.dead_time; ++i) {
    record.force.insert(record.force.begin(), record.force.front());
    record.force.pop_back();
  }
  return record;
}

RigidModel together(std::vector<MotionRecord> const& records) {
  return rigid_model_of(records, T);
}
RigidModel model_of(Axis const& axis) {
  return together({recorded(axis)});
}

void check_inside(Estimate const& estimate, double truth) {
  INFO(estimate.value << " +- " << estimate.uncertainty << ", true " << truth);
  CHECK(std::abs(estimate.value - truth) <= estimate.uncertainty);
}

}  // namespace

TEST_CASE("a window has the derivatives of a polynomial") {
  auto const window = make_window(30, T);
  std::vector<double> line, parabola, quartic;
  for (std::size_t k = 0; k < window.velocity.size(); ++k) {
    double const t = (static_cast<double>(k) - 16.5) * T;  // 0 in the middle
    line.push_back(7 + 2 * t);
    parabola.push_back(3 * t * t / 2);
    quartic.push_back(std::pow(t, 4));
  }
  CHECK(derivative_at(window.velocity, line) == Approx(2));
  CHECK(derivative_at(window.acceleration, line) == Approx(0).margin(1e-6));
  CHECK(derivative_at(window.acceleration, parabola) == Approx(3));
  CHECK(derivative_at(window.fourth, quartic) == Approx(24));
}

TEST_CASE("mass, friction and gravity are found with their uncertainties") {
  Axis const axis;
  auto const model = model_of(axis);
  REQUIRE(model.has_mass());
  check_inside(model.mass, axis.mass);
  check_inside(model.coulomb, axis.coulomb);
  check_inside(model.viscous, axis.viscous);
  check_inside(model.constant, axis.constant);
  CHECK(model.mass.value == Approx(axis.mass).epsilon(0.01));
  CHECK(model.coulomb.value == Approx(axis.coulomb).epsilon(0.02));
  CHECK(model.has_coulomb());
  CHECK(model.explained > 0.99);
  CHECK(model.dead_time == 0);
}

TEST_CASE("the force may come later than the motion") {
  for (int const dead_time : {2, 5}) {
    auto const model = model_of({.dead_time = dead_time});
    REQUIRE(model.has_mass());
    CHECK(model.dead_time == dead_time);
    CHECK(model.mass.value == Approx(300).epsilon(0.01));
  }
}

TEST_CASE("an axis without friction has none that is negative") {
  auto const model = model_of({.viscous = 0, .coulomb = 0, .force_noise = 5});
  REQUIRE(model.has_mass());
  CHECK(model.coulomb.value >= 0);
  CHECK(model.viscous.value >= 0);
  CHECK_FALSE(model.has_coulomb());
  CHECK_FALSE(model.has_viscous());
}

TEST_CASE("a moderate spring between motor and load does not shift the mass") {
  auto const model = model_of({.elastic = 0.01});
  REQUIRE(model.has_mass());
  CHECK(model.mass.value == Approx(300).epsilon(0.02));
}

TEST_CASE("several recordings count together") {
  Axis const brief{.moves = 5};
  auto const record = recorded(brief);
  auto const model = together({record, recorded({.moves = 9}), record});
  REQUIRE(model.has_mass());
  check_inside(model.mass, 300);
}

TEST_CASE("what recordings do not show is refused with its reason") {
  SECTION("no motion") {
    MotionRecord const rest{.position = std::vector(3000, 1.0), .force = std::vector(3000, 5.0)};
    CHECK(together({rest}).doubt == RigidDoubt::no_motion);
    CHECK(together({MotionRecord{}}).doubt == RigidDoubt::no_motion);
  }
  SECTION("one direction only") {
    CHECK(model_of({.is_one_way = true}).doubt == RigidDoubt::one_direction);
  }
  SECTION("too short") {
    auto record = recorded({});
    record.position.resize(900);
    record.force.resize(900);
    CHECK(together({record}).doubt == RigidDoubt::too_short);
  }
  SECTION("a coarse position") {
    CHECK(model_of({.position_noise = 1e-3}).doubt == RigidDoubt::coarse);
  }
  SECTION("hardly any acceleration: friction is nearly all of the force") {
    CHECK(model_of({.mass = 1, .viscous = 0, .moves = 8, .longest = 2}).doubt == RigidDoubt::no_acceleration);
  }
  SECTION("something else moves the axis") {
    auto record = recorded({});
    for (std::size_t k = 0; k < record.force.size(); ++k) {
      record.force[k] += 600 * std::sin(0.004 * static_cast<double>(k));
    }
    CHECK(together({record}).doubt == RigidDoubt::unexplained);
  }
  SECTION("two loads") {
    CHECK(together({recorded({}), recorded({.mass = 420})}).doubt == RigidDoubt::scattered);
  }
  SECTION("a soft spring") {
    CHECK(model_of({.elastic = 0.5}).doubt == RigidDoubt::elastic);
  }
}

}  // namespace rigid_model_test
