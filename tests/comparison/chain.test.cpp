#include "comparison/chain.hpp"

#include "support/catch.hpp"

namespace axisc::comparison {
namespace {

constexpr design::CycleTime cycle_time{1'000'000};

Link lag() {
  return link_of(design::design_filter({.type = design::FilterType::pt1, .time_constant = {10000}},
                                       cycle_time, design::Precision::quick));
}

TEST_CASE("a recording at rest stays where it is") {
  std::vector<double> const rest(50, 1234567.0);
  CHECK(respond({lag(), Link{.taps = {0.25, 0.5, 0.25}}}, rest) == rest);
}

TEST_CASE("taps answer a step with their sums") {
  std::vector<double> const step{1, 1, 2, 2, 2, 2};
  CHECK(respond({Link{.taps = {0.25, 0.5, 0.25}}}, step) == std::vector<double>{1, 1, 1.25, 1.75, 2, 2});
}

TEST_CASE("the backward Euler method makes of a lag what textbooks say") {
  // Without pre-warping a = T/(T + tau).
  design::FilterSpecification wanted{.type = design::FilterType::pt1, .time_constant = {10000}};
  wanted.reading = design::FilterReading::backward_euler;
  auto const euler = link_of(design::design_filter(wanted, cycle_time, design::Precision::quick));
  std::vector<double> const answer = respond({euler}, std::vector<double>{0, 1, 1, 1});
  double const a = 1.0 / 11;
  CHECK(std::abs(answer[1] - a) < 1e-9);
  CHECK(std::abs(answer[2] - (a + (1 - a) * a)) < 1e-9);
}

}  // namespace
}  // namespace axisc::comparison
