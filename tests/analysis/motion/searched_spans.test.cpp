// What a search looks at, counted in cycles.
#include "analysis/motion/searched_spans.hpp"

#include "support/catch.hpp"

#include <memory>
#include <numbers>
#include <numeric>

namespace axisc::motion::searched_spans_test {
namespace {

constexpr double before = 100;
constexpr double after = 50;

/// A circle of radius 1000 at one velocity.
TimedPiece circle(double velocity) {
  auto const arc = std::make_shared<Arc>();
  arc->radius = 1000;
  arc->sweep = 2 * std::numbers::pi;
  arc->length = arc->radius * arc->sweep;
  TimedPiece piece;
  piece.path = Segment({}, {}, arc);
  piece.length = arc->length;
  piece.phase = Phase::steady(velocity, arc->length);
  piece.duration = piece.phase.duration;
  return piece;
}

double searched_cycles(TimedPiece const& piece) {
  auto const parts = searched_spans({&piece, 1}, {.from = 0, .to = piece.end()}, before, after);
  CHECK(parts.front().from == 0);
  CHECK(parts.back().to == piece.end());
  double cycles = 0;
  double behind = -1;
  for (auto const& part : parts) {
    CHECK(part.from > behind);
    behind = part.to;
    cycles += part.to - part.from + before + after;
  }
  return cycles;
}

}  // namespace

TEST_CASE("a search looks at all that is fast, and at the same places of a slow circle however slow it is") {
  auto const fast = circle(2);
  CHECK(searched_cycles(fast) == Approx(fast.duration + before + after));
  double const slow = searched_cycles(circle(0.05));
  CHECK(slow < 66 * 2 * (before + after));
  CHECK(searched_cycles(circle(0.0005)) < 1.1 * slow);
}

TEST_CASE("a search looks at both ends of a line that is slow") {
  TimedPiece piece;
  piece.length = 1e6;
  piece.path = Segment({}, {1});
  piece.phase = Phase::steady(1, 1e6);
  piece.duration = piece.phase.duration;
  CHECK(searched_cycles(piece) == Approx(3 * (before + after)));
}

TEST_CASE("a search that begins and ends within a steady stretch looks at its ends") {
  auto const piece = circle(0.0005);
  auto const parts =
      searched_spans({&piece, 1}, {.from = 1e6, .to = 1e6 + 10'000, .phase = 0.25}, before, after);
  CHECK(parts.front().from == 1e6);
  CHECK(parts.back().to == 1e6 + 10'000);
  for (auto const& part : parts) CHECK(part.phase == 0.25);
}

}  // namespace axisc::motion::searched_spans_test
