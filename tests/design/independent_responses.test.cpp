// Against data/responses.json, whose origin is data/make_responses.py: whole polynomials in 80 decimal
// digits.
#include "design/filter_analysis.hpp"
#include "design/filter_design.hpp"
#include "support/catch.hpp"
#include "tests/design/increment_filter.hpp"

#include <algorithm>
#include <complex>
#include <fstream>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace independent_responses_test {

namespace {

using namespace axisc::design;

std::map<std::string, FilterType> const types{
    {"LOWPASS", FilterType::lowpass},   {"HIGHPASS", FilterType::highpass},
    {"BANDPASS", FilterType::bandpass}, {"BANDSTOP", FilterType::bandstop},
    {"ALLPASS", FilterType::allpass},   {"PT1", FilterType::pt1},
    {"PT2", FilterType::pt2},           {"TIME_DELAY", FilterType::time_delay}};

std::map<std::string, Prototype> const prototypes{{"CRIT_DAMPING", Prototype::critical_damping},
                                                  {"BUTTERWORTH", Prototype::butterworth},
                                                  {"BESSEL", Prototype::bessel}};

FilterSpecification specification(nlohmann::json const& item) {
  FilterSpecification filter{.type = types.at(item.at("type"))};
  if (item.contains("prototype")) filter.prototype = prototypes.at(item.at("prototype"));
  filter.order = item.value("order", 1U);
  filter.frequency = {std::stod(item.value("frequency", "30"))};
  filter.quality = std::stod(item.value("quality", "1"));
  filter.time_constant = {std::stod(item.value("time_constant", "10000"))};
  filter.share_percent = std::stod(item.value("share", "100"));
  return filter;
}

/// The cycles that make_responses.py kept of the step response.
bool is_kept(std::size_t cycle) {
  return cycle < 4 || (cycle >= 7 && (cycle - 7) % 28 == 0);
}

}  // namespace

TEST_CASE("every type and prototype agrees with independent arithmetic") {
  Precision const precision = GENERATE(Precision::quick, Precision::exact);
  std::ifstream file(AXISC_SOURCE_DIR "/tests/design/data/responses.json");
  REQUIRE(file);
  auto const items = nlohmann::json::parse(file);
  REQUIRE(items.size() > 40);
  for (auto const& item : items) {
    INFO(item);
    CycleTime const cycle_time{item.at("cycle_time_us").get<std::uint32_t>() * 1000};
    FilterDesign const design = design_filter(specification(item), cycle_time, precision);
    for (auto const& point : item.at("response")) {
      std::complex<double> const expected{point.at(1).get<double>(), point.at(2).get<double>()};
      CHECK(std::abs(response(design, {point.at(0).get<double>()}, cycle_time) - expected) < 1e-12);
    }
    IncrementFilter filter({design});
    auto const& step = item.at("step");
    for (std::size_t cycle = 0, kept = 0; kept < step.size(); ++cycle) {
      double const y = filter.step(1.0);
      if (is_kept(cycle)) CHECK(std::abs(y - step.at(kept++).get<double>()) < 1e-12);
    }
  }
}

}  // namespace independent_responses_test
