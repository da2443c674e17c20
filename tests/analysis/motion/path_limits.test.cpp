#include "analysis/motion/path_block.hpp"
#include "support/catch.hpp"

#include <cmath>

namespace axisc::motion {

TEST_CASE("no axis exceeds its velocity or acceleration along a path") {
  PathLimits const limits({{.velocity = 300, .acceleration = 8}, {.velocity = 100, .acceleration = 6}});
  CHECK(limits.velocity({1, 0}) == 300);
  CHECK(limits.velocity({0, -1}) == 100);
  CHECK(limits.velocity({0.6, 0.8}) == Approx(125));
  CHECK(limits.acceleration({0.6, 0.8}) == Approx(7.5));
}

TEST_CASE("a corner is passed with the velocity step that the axes may make in one cycle") {
  // 90°: both axes change by v; 180°: one changes by 2 v.
  PathLimits const plain({{.velocity = 300, .acceleration = 8}, {.velocity = 300, .acceleration = 6}});
  CHECK(plain.corner({-1, 1}, 1) == Approx(6));
  CHECK(plain.corner({-2, 0}, 1) == Approx(4));
  CHECK(std::isinf(plain.corner({0, 0}, 1)));
  CHECK(plain.corner({-1, 1}, 10) == Approx(6));
  // P-AXIS-00013 = 500 (50 %): a T (1 + 0.5 f)
  PathLimits const weighted(
      {{.acceleration = 8, .transition_weight = 0.5}, {.acceleration = 6, .transition_weight = 0.5}});
  CHECK(weighted.corner({-1, 1}, 1) == Approx(9));
  CHECK(weighted.corner({-1, 1}, 10) == Approx(36));
}

}  // namespace axisc::motion
