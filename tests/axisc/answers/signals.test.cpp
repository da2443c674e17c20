#include "axisc/answers/execution/signals.hpp"

#include "support/catch.hpp"

using axisc::Signal;
using axisc::design::CycleTime;

namespace {

double at(char const* text, std::uint64_t n, double amplitude = 1) {
  return Signal::parse(text).value().at(n, amplitude, CycleTime{500'000});
}

}  // namespace

TEST_CASE("a step is there from cycle 0 on") {
  CHECK(at("step", 0) == 1);
  CHECK(at("step", 1'000'000'000'000, 2.5) == 2.5);
}

TEST_CASE("an impulse is one cycle long") {
  CHECK(at("impulse", 0, 3) == 3);
  CHECK(at("impulse", 1, 3) == 0);
}

TEST_CASE("a ramp counts in seconds") {
  CHECK(at("ramp:1000", 0) == 0);
  CHECK(at("ramp:1000", 1) == 0.5);
  CHECK(at("ramp:-4", 2000, 10) == -40);
}

TEST_CASE("a sine stays exact over a long time") {
  CHECK(at("sine:100", 0) == 0);
  CHECK(at("sine:100", 5) == Approx(1).epsilon(1e-12));
  CHECK(at("sine:100", 15, 2) == Approx(-2).epsilon(1e-12));
  CHECK(at("sine:100", 20'000'000'005) == Approx(1).epsilon(1e-9));
}

TEST_CASE("what is no signal") {
  for (auto const* const text :
       {"", "Step", "ramp", "ramp:", "ramp:x", "sine:1Hz", "sine:nan", "chirp:1", "step:1"}) {
    INFO(text);
    CHECK_FALSE(Signal::parse(text));
  }
}
