// Errors that a simulated machine was given are found again, each by itself.
#include "analysis/circle/causes.hpp"

#include "analysis/circle/deviations.hpp"
#include "analysis/circle/external_turns.hpp"
#include "simulated_circle.hpp"
#include "support/catch.hpp"

#include <variant>
#include <vector>

namespace axisc::circle::causes_test {
namespace {

std::vector<Turn> turns_of(SimulatedCircle const& machine) {
  std::vector<Turn> turns;
  for (auto const sense : {Sense::counterclockwise, Sense::clockwise}) {
    auto found = recorded_turns(machine.path(sense));
    REQUIRE(std::holds_alternative<std::vector<Turn>>(found));
    auto& own = std::get<std::vector<Turn>>(found);
    REQUIRE(own.size() == 1);
    REQUIRE(own.front().sense == sense);
    turns.push_back(std::move(own.front()));
  }
  return turns;
}

TEST_CASE("each cause is told apart from the others") {
  SimulatedCircle machine;
  machine.delay = {0.0102, 0.010};
  machine.gain = {0.9999, 0.99985};
  machine.backlash = {0.004, -0.002};
  machine.squareness = 2e-5;
  auto const turns = turns_of(machine);
  auto const causes = causes_of(turns, 50'000);
  REQUIRE(causes);
  CHECK(causes->delay_difference / machine.omega() == Approx(0.0002).margin(5e-7));
  CHECK(causes->gain_difference == Approx(5e-5).margin(1e-6));
  CHECK(causes->radius == Approx(50'000 * (0.999875 - 1)).margin(0.05));
  CHECK(causes->squareness == Approx(2e-5).margin(1e-6));
  CHECK(causes->backlash[0] == Approx(4).margin(0.05));
  CHECK(causes->backlash[1] == Approx(-2).margin(0.05));
  CHECK(causes->is_separable);
  CHECK(causes->unexplained_rms < 0.05);
}

TEST_CASE("spikes of friction are found where the axis reverses") {
  SimulatedCircle machine;
  machine.spike = {0, 0.006};
  auto const causes = causes_of(turns_of(machine), 50'000);
  REQUIRE(causes);
  for (std::size_t i = 0; i < causes->spikes.size(); ++i) {
    // u+, v+, u-, v-: v reverses at every second. The first sample comes up to a cycle later.
    double const expected = i % 2 == 1 ? 6 : 0;
    CHECK(causes->spikes.at(i) == Approx(expected).margin(i % 2 == 1 ? 6 * 0.2 : 0.1));
  }
  CHECK(causes->is_separable);
}

TEST_CASE("friction that decays too slowly is not given as backlash") {
  SimulatedCircle machine;
  machine.radius = 10;
  machine.spike = {0.005, 0};
  machine.spike_time = 0.05;
  auto const causes = causes_of(turns_of(machine), 10'000);
  REQUIRE(causes);
  CHECK_FALSE(causes->is_separable);
}

TEST_CASE("figures of a delay are those of an ellipse") {
  SimulatedCircle machine;
  machine.delay = {0.0105, 0.010};
  auto const found = deviations_of(turns_of(machine), 50'000);
  // 50 mm/s times 0.5 ms.
  CHECK(*found.counterclockwise == Approx(25).margin(0.2));
  CHECK(*found.clockwise == Approx(25).margin(0.2));
  CHECK(*found.bidirectional == Approx(25).margin(0.2));
  CHECK(*found.hysteresis == Approx(25).margin(0.2));
  CHECK(found.radial_max == Approx(12.5).margin(0.15));
  CHECK(found.radial_min == Approx(-12.5).margin(0.15));
}

TEST_CASE("an external instrument sees squareness, in turns that begin and end anywhere") {
  constexpr double radius = 150'000;
  std::vector<double> angles, deviations;
  auto const add = [&](double angle) {
    double const theta = angle * 3.14159265358979 / 180;
    angles.push_back(std::remainder(angle, 360));
    // 2e-5 rad:  ρ = -q sin 2θ,  q = R/2 times it.
    deviations.push_back(-radius * 2e-5 / 2 * std::sin(2 * theta));
  };
  for (double angle = -90; angle <= 330; angle += 0.5) add(angle);
  for (double angle = 330; angle >= -40; angle -= 0.5) add(angle);
  // The instrument rests at the end.
  for (int i = 0; i < 20; ++i) add(-40);
  auto const found = external_turns(angles, deviations, radius);
  REQUIRE(std::holds_alternative<std::vector<Turn>>(found));
  auto const& turns = std::get<std::vector<Turn>>(found);
  REQUIRE(turns.size() == 2);
  auto const causes = causes_of(turns, radius);
  REQUIRE(causes);
  CHECK(causes->squareness == Approx(2e-5).margin(1e-8));
  CHECK(deviations_of(turns, radius).bidirectional.value() == Approx(3).margin(0.01));
}

}  // namespace
}  // namespace axisc::circle::causes_test
