// Which part of a recording is the turn that counts, and what is refused.
#include "analysis/circle/recorded_turns.hpp"

#include "simulated_circle.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <numbers>
#include <variant>

namespace axisc::circle::recorded_turns_test {
namespace {

std::vector<Turn> turns_of(RecordedPath const& path) {
  auto found = recorded_turns(path);
  if (auto const* const bad = std::get_if<BadTurn>(&found)) {
    FAIL("problem " << static_cast<int>(bad->problem) << ", " << bad->degrees << "°");
  }
  return std::get<std::vector<Turn>>(std::move(found));
}

BadTurn refusal_of(RecordedPath const& path) {
  auto found = recorded_turns(path);
  REQUIRE(std::holds_alternative<BadTurn>(found));
  return std::get<BadTurn>(found);
}

void append(RecordedPath& path, double u, double v) {
  path.setpoint_u.push_back(u);
  path.setpoint_v.push_back(v);
  path.actual_u.push_back(u);
  path.actual_v.push_back(v);
}

void append(RecordedPath& path, RecordedPath const& more) {
  for (std::size_t i = 0; i < more.actual_u.size(); ++i) {
    path.setpoint_u.push_back(more.setpoint_u[i]);
    path.setpoint_v.push_back(more.setpoint_v[i]);
    path.actual_u.push_back(more.actual_u[i]);
    path.actual_v.push_back(more.actual_v[i]);
  }
}

/// From the first position, or to the last one, on the tangent.
RecordedPath with_tangents(SimulatedCircle const& machine, Sense sense, int cycles) {
  auto circle = machine.path(sense);
  RecordedPath path = circle;
  path.setpoint_u.clear(), path.setpoint_v.clear(), path.actual_u.clear(), path.actual_v.clear();
  auto const line = [&](std::size_t from, std::size_t to, int first, int last) {
    double const du = circle.setpoint_u[to] - circle.setpoint_u[from];
    double const dv = circle.setpoint_v[to] - circle.setpoint_v[from];
    for (int i = first; i <= last; ++i) {
      append(path, circle.setpoint_u[to] + i * du, circle.setpoint_v[to] + i * dv);
    }
  };
  line(1, 0, cycles, 1);
  for (int i = cycles; i > 0; --i) {
    append(path, circle.setpoint_u[0] - i * (circle.setpoint_u[1] - circle.setpoint_u[0]),
           circle.setpoint_v[0] - i * (circle.setpoint_v[1] - circle.setpoint_v[0]));
  }
  append(path, circle);
  auto const end = circle.setpoint_u.size() - 1;
  line(end - 1, end, 1, cycles);
  return path;
}

TEST_CASE("the last 360° count") {
  SimulatedCircle const machine;
  auto const path = machine.path(Sense::counterclockwise);
  auto const turns = turns_of(path);
  REQUIRE(turns.size() == 1);
  auto const& turn = turns.front();
  double weight = 0;
  for (auto const& sample : turn.samples) weight += sample.weight;
  CHECK(weight == Approx(2 * std::numbers::pi));
  CHECK(turn.radius == Approx(50'000).margin(0.01));
  CHECK(turn.angular_speed == Approx(machine.omega()).epsilon(1e-5));
  // 2π R / (v T) steps, one more point, and one that the turn cuts.
  CHECK(turn.samples.size() == static_cast<std::size_t>(2 * std::numbers::pi / machine.omega() / 0.002) + 2);
  CHECK(turn.samples.back().u == Approx(path.actual_u.back() - 100'000).margin(0.05));
}

TEST_CASE("both directions in one recording, with rests between them") {
  SimulatedCircle const machine;
  auto path = machine.path(Sense::counterclockwise);
  path.resolution = 0.1;
  for (int i = 0; i < 500; ++i) append(path, path.setpoint_u.back(), path.setpoint_v.back());
  append(path, machine.path(Sense::clockwise));
  auto const turns = turns_of(path);
  REQUIRE(turns.size() == 2);
  CHECK(turns[0].sense == Sense::counterclockwise);
  CHECK(turns[1].sense == Sense::clockwise);
}

TEST_CASE("straight lines that touch the circle at the same speed do not count") {
  SimulatedCircle const machine;
  auto const path = with_tangents(machine, Sense::clockwise, 400);
  auto const turns = turns_of(path);
  REQUIRE(turns.size() == 1);
  CHECK(turns.front().radius == Approx(50'000).margin(0.02));
  for (auto const& sample : turns.front().samples) {
    CHECK(std::hypot(sample.u, sample.v) == Approx(50'000).margin(0.15));
  }
}

TEST_CASE("what the filters have not settled in does not count") {
  SimulatedCircle machine;
  machine.turns = 1.2;
  auto path = machine.path(Sense::counterclockwise);
  CHECK(turns_of(path).size() == 1);
  path.settling = 0.3 * 2 * std::numbers::pi / machine.omega();
  auto const bad = refusal_of(path);
  CHECK(bad.problem == TurnProblem::less_than_turn);
  CHECK(bad.degrees == Approx(0.9 * 360).margin(1));
}

TEST_CASE("less than a turn is refused with what there is") {
  SimulatedCircle machine;
  machine.turns = 0.75;
  auto const bad = refusal_of(machine.path(Sense::clockwise));
  CHECK(bad.problem == TurnProblem::less_than_turn);
  CHECK(bad.degrees == Approx(270).margin(1));
}

TEST_CASE("below 120 points a turn is refused") {
  SimulatedCircle machine;
  machine.cycle = 2 * std::numbers::pi / machine.omega() / 117;
  auto const bad = refusal_of(machine.path(Sense::clockwise));
  CHECK(bad.problem == TurnProblem::few_points);
  CHECK(bad.points < 120);
  machine.cycle *= 117.0 / 120;
  CHECK(turns_of(machine.path(Sense::clockwise)).front().samples.size() >= 120);
}

TEST_CASE("rests and straight lines are no circle") {
  RecordedPath path;
  path.sample_time = 0.002;
  for (int i = 0; i < 2000; ++i) append(path, 5, 7);
  CHECK(refusal_of(path).problem == TurnProblem::no_motion);
  path = {};
  path.sample_time = 0.002;
  for (int i = 0; i < 2000; ++i) append(path, i * 50.0, i * 20.0);
  CHECK(refusal_of(path).problem == TurnProblem::no_circle);
  path = {};
  path.sample_time = 0.002;
  append(path, 0, 0);
  CHECK(refusal_of(path).problem == TurnProblem::no_motion);
}

TEST_CASE("without setpoints the actual positions tell the turn") {
  SimulatedCircle machine;
  machine.spike = {0.004, 0.004};
  auto path = machine.path(Sense::counterclockwise);
  path.setpoint_u.clear();
  path.setpoint_v.clear();
  auto const turns = turns_of(path);
  REQUIRE(turns.size() == 1);
  CHECK(turns.front().radius == 0);
}

TEST_CASE("lost samples do not count") {
  SimulatedCircle const machine;
  auto path = machine.path(Sense::counterclockwise);
  auto const at = path.actual_u.size() - 100;
  path.actual_u[at] += 500;
  path.gaps = {at};
  auto const turns = turns_of(path);
  for (auto const& sample : turns.front().samples) {
    CHECK(std::hypot(sample.u, sample.v) == Approx(50'000).margin(1));
  }
}

}  // namespace
}  // namespace axisc::circle::recorded_turns_test
