#include "axisc/answers/suggestion/guard_coverage.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace axisc {
namespace {

/// Two equal impulses, half a period of 20 cycles apart.
tuning::Chain guard_at_25_hz() {
  return {.kernel = design::KernelSpecification{
              .type = design::KernelType::vibration_guard, .order = 1, .frequency = {25}, .quality = 0}};
}

GuardCoverage found_for(std::vector<tuning::Resonance> resonances) {
  tuning::Task const task{.cycle_time = {1'000'000}, .resonances = std::move(resonances)};
  return guard_coverage(guard_at_25_hz(), task).value();
}

}  // namespace

TEST_CASE("a guard's interval is held against the resonance with twice its uncertainty") {
  // |cos(π r/2)| ≤ 0.05 within ±(2/π) asin 0.05 of the frequency: from 24.204 to 25.796 Hz.
  double const half = 25 * 2 / std::numbers::pi * std::asin(0.05);
  auto const named = found_for({{.frequency = 25}});
  REQUIRE(named.interval);
  CHECK(named.interval->from.value == Approx(25 - half).epsilon(1e-6));
  CHECK(named.interval->to.value == Approx(25 + half).epsilon(1e-6));
  CHECK(named.coverage == Coverage::within);
  CHECK(named.uncertainty == 0);
  CHECK(found_for({{.frequency = 25, .uncertainty = 0.39}}).coverage == Coverage::within);
  CHECK(found_for({{.frequency = 25, .uncertainty = 0.41}}).coverage == Coverage::in_part);
  CHECK(found_for({{.frequency = 25.5, .uncertainty = 0.2}}).coverage == Coverage::in_part);
  CHECK(found_for({{.frequency = 26}}).coverage == Coverage::outside);
  CHECK(found_for({{.frequency = 26, .uncertainty = 1}}).coverage == Coverage::outside);
  CHECK(presentation::text_of(coverage_words(found_for({{.frequency = 25, .uncertainty = 0.41}})),
                              Language::german) ==
        "der Vibration Guard lässt von 24,2 Hz bis 25,8 Hz höchstens 5 % übrig (eine Lesart); die Resonanz, "
        "25 Hz ± 0,82 Hz (das Doppelte ihrer Unsicherheit), kann außerhalb liegen");
}

TEST_CASE("of several resonances the one counts that the guard is nearest to") {
  auto const found = found_for({{.frequency = 60}, {.frequency = 25.2, .uncertainty = 0.1}});
  CHECK(found.resonance.frequency == 25.2);
  CHECK(found.coverage == Coverage::within);
}

TEST_CASE("a guard without an interval, and a chain without a guard") {
  auto chain = guard_at_25_hz();
  chain.kernel->quality = 0.5;
  tuning::Task const task{.cycle_time = {1'000'000}, .resonances = {{.frequency = 25}}};
  auto const damped = guard_coverage(chain, task);
  REQUIRE(damped);
  CHECK(damped->coverage == Coverage::no_interval);
  CHECK_FALSE(damped->interval);
  CHECK_FALSE(guard_coverage({.kernel = design::KernelSpecification{.order = 20}}, task));
  CHECK_FALSE(guard_coverage({}, task));
}

}  // namespace axisc
