// The parts of `compare --program`; what they do together is tested by motion_recordings.py, with another
// program.
#include "analysis/comparison/motion/motion_comparison.hpp"
#include "analysis/comparison/motion/planned_move.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <set>

namespace axisc::comparison::motion_test {
namespace {

/// 2000 mm/s², ramps of 50 ms, slope TRAPEZ, cycles of 1 ms.
motion::PathDynamics trapez() {
  motion::PathDynamics dynamics;
  dynamics.axes.resize(2);
  for (auto& axis : dynamics.axes) axis.feed.up.acceleration = axis.feed.down.acceleration = 2000;
  dynamics.channel.slope = machine::Slope::trapez;
  return dynamics;
}

motion::ProgrammedBlock block_to(double x_mm, double y_mm = 0) {
  motion::ProgrammedBlock block;
  block.end = {x_mm * motion::units_per_mm, y_mm * motion::units_per_mm};
  block.feed = 6000.0 / 60 * motion::units_per_mm * 1e-3;
  return block;
}

Move move_of(std::vector<motion::ProgrammedBlock> blocks) {
  return {.begin = {}, .blocks = std::move(blocks)};
}

/// Whole units of a plan of X that begins after `rest` cycles, with a constant.
RecordedPath recorded(std::vector<motion::Point> const& plan, std::size_t rest, double constant) {
  std::vector<double> values(rest, std::round(constant));
  for (auto const& point : plan) values.push_back(std::round(point[0] + constant));
  values.resize(values.size() + rest, values.back());
  RecordedPath path;
  path.positions.push_back(recorded_position(0, std::move(values), 1));
  return path;
}

MotionComparison compared(Move const& move, RecordedPath const& path) {
  return std::get<MotionComparison>(compare_motion({move}, trapez(), path));
}

}  // namespace

TEST_CASE("each reading of each key meets all others once") {
  auto const all = all_combinations();
  CHECK(all.size() == 2 * 2 * 3 * 2 * 3 * 2 * 2 * 2);
  CHECK(std::set<Combination>(all.begin(), all.end()).size() == all.size());
  CHECK(all.front() == combination_of({}));
  for (auto const& one : all) CHECK(combination_of(readings_of(one)) == one);
}

TEST_CASE("moves lie between rests that a recording shows") {
  RecordedPath path;
  path.positions.push_back(recorded_position(0, {0, 0, 1, 2, 2, 3, 3, 3, 3, 4, 4}, 1));
  path.positions.push_back(recorded_position(1, {5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6}, 1));
  auto const short_rests = moving_stretches(path, 3);
  REQUIRE(short_rests.size() == 2);
  CHECK(short_rests[0].begin == 1);
  CHECK(short_rests[0].end == 6);
  CHECK(short_rests[1].begin == 8);
  CHECK(short_rests[1].end == 9);
  CHECK(moving_stretches(path, 4).size() == 1);
}

TEST_CASE("a program is cut where it rests, and refused where it rests too briefly") {
  auto const cut = [](double rest) {
    ProgramMoves moves{design::CycleTime{1'000'000}};
    moves.motion(block_to(0));  // of no length
    moves.motion(block_to(1));
    moves.motion(block_to(2));
    moves.stop(rest, 7);
    moves.motion(block_to(0));
    return moves;
  };
  auto const long_rest = cut(200);
  REQUIRE(long_rest.moves().size() == 2);
  CHECK(long_rest.moves()[0].blocks.size() == 2);
  CHECK(long_rest.moves()[1].begin == block_to(2).end);
  CHECK_FALSE(long_rest.problem());
  auto const short_rest = cut(199);
  REQUIRE(short_rest.problem());
  CHECK(short_rest.problem()->line == 7);
}

TEST_CASE("keys that act in a move are those whose readings its slope, axes and junctions meet") {
  auto const keys = [](Move const& move, motion::PathDynamics const& dynamics) {
    return acting_keys(move, dynamics).to_string();
  };
  // hsc, cycles, weights, corner, circle, sine, borders, projection
  CHECK(keys(move_of({block_to(1)}), trapez()) == "01000000");
  CHECK(keys(move_of({block_to(1, 1)}), trapez()) == "01000001");
  CHECK(keys(move_of({block_to(1), block_to(2)}), trapez()) == "01110010");
  auto dynamics = trapez();
  dynamics.channel.transition_mode = 1;
  dynamics.channel.slope = machine::Slope::hsc;
  CHECK(keys(move_of({block_to(1), block_to(2)}), dynamics) == "11010000");
  dynamics.channel.slope = machine::Slope::step;
  CHECK(keys(move_of({block_to(1, 1)}), dynamics) == "01000000");
  // What does not act changes nothing.
  for (auto const& move :
       {move_of({block_to(1)}), move_of({block_to(3, 2)}), move_of({block_to(1), block_to(2, 1)})}) {
    auto const acting = acting_keys(move, trapez());
    for (auto const& readings : all_combinations()) {
      CHECK(planned_setpoints(move, trapez(), readings, 5000) ==
            planned_setpoints(move, trapez(), only(readings, acting), 5000));
    }
  }
}

TEST_CASE("a plan lies over its own recording, whatever the zero and the beginning of both") {
  auto const move = move_of({block_to(2)});
  auto const plan = *planned_setpoints(move, trapez(), {}, 1000);
  // 2 mm with j = 40 m/s³: 4 ∛(2 mm / 2 j) = 116.96 ms.
  CHECK(plan.size() == 118);
  for (double const constant : {0.0, 0.5, 123456.3}) {
    auto const result = compared(move, recorded(plan, 300, constant));
    CHECK(result.agrees());
    CHECK(result.current.deviation.largest <= 0.5 + 1e-9);
    CHECK(result.keys[index_of(MotionKey::cycles)].is_told());
    CHECK_FALSE(result.keys[index_of(MotionKey::sine)].is_told());
  }
}

TEST_CASE("what rounding does not explain fits nothing") {
  auto const move = move_of({block_to(2)});
  auto const plan = *planned_setpoints(move, trapez(), {}, 1000);
  auto path = recorded(plan, 300, 0);
  path.positions[0].values[350] += 2;
  auto const result = compared(move, path);
  CHECK_FALSE(result.agrees());
  CHECK_FALSE(result.best.deviation.fits());
  for (auto const& verdict : result.keys) CHECK_FALSE(verdict.is_told());
  // That cycle was lost: it does not count.
  path.is_gap.assign(path.size(), 0);
  path.is_gap[350] = 1;
  CHECK(compared(move, path).agrees());
}

TEST_CASE("moves are found among others by their ways") {
  auto const plan = *planned_setpoints(move_of({block_to(2)}), trapez(), {}, 1000);
  auto path = recorded(plan, 300, 0);
  auto const other = recorded(*planned_setpoints(move_of({block_to(5)}), trapez(), {}, 1000), 300, 20'000);
  auto& values = path.positions[0].values;
  values.insert(values.end(), other.positions[0].values.begin(), other.positions[0].values.end());
  CHECK(compared(move_of({block_to(5)}), path).agrees());
  CHECK(compared(move_of({block_to(2)}), path).agrees());
  auto const missing = compare_motion({move_of({block_to(3)})}, trapez(), path);
  REQUIRE(std::holds_alternative<NoSuchMoves>(missing));
  CHECK(std::get<NoSuchMoves>(missing).recorded == 2);
}

}  // namespace axisc::comparison::motion_test
