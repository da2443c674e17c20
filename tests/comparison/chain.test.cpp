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

TEST_CASE("pieces of an input have the answer of the whole") {
  std::vector<double> input;
  for (int n = 0; n < 3000; ++n) input.push_back(n % 700 < 350 ? 5.0 * n : 1e6 - n);
  auto const blocking =
      link_of(design::design_filter({.type = design::FilterType::highpass, .order = 2, .frequency = {15}},
                                    cycle_time, design::Precision::quick));
  Chain const chain{lag(), Link{.taps = std::vector<double>(41, 1.0 / 41)}, blocking,
                    Link{.taps = {0.5, 0.5}}};
  auto const whole = respond(chain, input);
  Runner runner(chain);
  auto pieces = input;
  std::size_t length = 1;
  for (std::size_t first = 0; first < pieces.size(); first += length) {
    length = length * 3 % 601 + 1;
    runner.run(std::span(pieces).subspan(first, std::min(length, pieces.size() - first)));
  }
  for (std::size_t n = 0; n < whole.size(); ++n) CHECK(std::abs(pieces[n] - whole[n]) < 1e-6);
}

}  // namespace
}  // namespace axisc::comparison
