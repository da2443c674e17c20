#include "analysis/comparison/telling_motion.hpp"

#include "support/catch.hpp"

#include <array>

namespace axisc::comparison::telling_motion_test {
namespace {

constexpr Sentence meaning{"other taps", "andere Koeffizienten"};
constexpr Motions motions{.velocity = 1000, .step = 10'000};

Reading moving_average(std::size_t taps) {
  std::vector<double> const weights(taps, 1 / static_cast<double>(taps));
  return {{Departure{"taps", meaning}}, Chain{Link{.taps = weights}}};
}

/// Rounded to whole units.
Comparison rounded() {
  return {.input_resolution = 1, .output_resolution = 1, .allowed_rms = 0.408};
}

TEST_CASE("a jump of the velocity tells kernels of different lengths apart, but not equal ones") {
  std::array const lengths{moving_average(9), moving_average(10)};
  CHECK(telling_motion(lengths, rounded(), motions) == Motion::velocity_jump);
  std::array const equal{moving_average(9), moving_average(9)};
  CHECK(telling_motion(equal, rounded(), motions) == Motion::none);
  // One pair that nothing tells apart is enough.
  std::array const three{moving_average(9), moving_average(10), moving_average(9)};
  CHECK(telling_motion(three, rounded(), motions) == Motion::none);
}

TEST_CASE("a delay of whole cycles is no difference") {
  auto delayed = moving_average(9);
  delayed.chain.front().taps.insert(delayed.chain.front().taps.begin(), 3, 0.0);
  std::array const pair{moving_average(9), delayed};
  CHECK(telling_motion(pair, rounded(), motions) == Motion::none);
}

TEST_CASE("a small difference needs a step") {
  // By 2e-4 of the input, in two neighbouring taps: a constant velocity shows none of it.
  auto other = moving_average(9);
  other.chain.front().taps[3] += 4e-4;
  other.chain.front().taps[4] -= 8e-4;
  other.chain.front().taps[5] += 4e-4;
  std::array const pair{moving_average(9), other};
  CHECK(telling_motion(pair, rounded(), motions) == Motion::step);
}

TEST_CASE("a single reading needs no motion") {
  std::array const one{moving_average(9)};
  CHECK_FALSE(telling_motion(one, rounded(), motions).has_value());
}

}  // namespace
}  // namespace axisc::comparison::telling_motion_test
