// The designs against independent responses: complex frequency response and step response within 1e-9.
#include "design/filter_analysis.hpp"
#include "design/filter_design.hpp"
#include "support/catch.hpp"
#include "tests/design/increment_filter.hpp"

#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace reference_responses_test {

namespace {

using namespace axisc::design;

FilterType type_named(std::string const& name) {
  static std::map<std::string, FilterType> const types{
      {"LOWPASS", FilterType::lowpass},   {"HIGHPASS", FilterType::highpass},
      {"BANDPASS", FilterType::bandpass}, {"BANDSTOP", FilterType::bandstop},
      {"ALLPASS", FilterType::allpass},   {"PT1", FilterType::pt1},
      {"PT2", FilterType::pt2},           {"TIME_DELAY", FilterType::time_delay}};
  return types.at(name);
}

Prototype prototype_named(std::string const& name) {
  static std::map<std::string, Prototype> const prototypes{{"CRIT_DAMPING", Prototype::critical_damping},
                                                           {"BUTTERWORTH", Prototype::butterworth},
                                                           {"BESSEL", Prototype::bessel}};
  return prototypes.at(name);
}

void set(FilterSpecification& filter, std::string const& parameter, std::string const& value) {
  if (parameter == "type") filter.type = type_named(value);
  if (parameter == "prototype") filter.prototype = prototype_named(value);
  if (parameter == "order") filter.order = static_cast<std::uint32_t>(std::stoul(value));
  if (parameter == "fg_f0") filter.frequency = {std::stod(value)};
  if (parameter == "guete") filter.quality = std::stod(value);
  if (parameter == "time_constant") filter.time_constant = {std::stod(value)};
  if (parameter == "share_percent") filter.share_percent = std::stod(value);
}

/// Filters of lines such as "filter[0].order 3", by index.
std::vector<FilterSpecification> specifications(nlohmann::json const& lines) {
  std::map<char, FilterSpecification> filters;
  for (std::string const line : lines) {
    auto const bracket = line.find("filter[");
    if (bracket == std::string::npos) continue;
    std::istringstream words(line.substr(bracket + 10));
    std::string parameter, value;
    words >> parameter >> value;
    set(filters[line.at(bracket + 7)], parameter, value);
  }
  std::vector<FilterSpecification> result;
  for (auto const& entry : filters) result.push_back(entry.second);
  return result;
}

struct Deviation {
  double response = 0;
  double step = 0;
};

Deviation deviation(nlohmann::json const& item, Precision precision) {
  CycleTime const cycle_time{item.at("cycle_time_us").get<std::uint32_t>() * 1000};
  std::vector<FilterDesign> chain;
  for (auto const& specification : specifications(item.at("list"))) {
    chain.push_back(design_filter(specification, cycle_time, precision));
  }

  Deviation worst;
  auto const& frequencies = item.at("frequency_hz");
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    auto const expected =
        std::polar(item.at("magnitude").at(i).get<double>(), item.at("phase_rad").at(i).get<double>());
    auto const point = chain_response(chain, {frequencies.at(i).get<double>()}, cycle_time);
    worst.response =
        std::max(worst.response, std::abs(std::polar(point.magnitude, point.phase_rad) - expected));
  }
  IncrementFilter filter(chain);
  for (double const expected : item.at("step")) {
    worst.step = std::max(worst.step, std::abs(filter.step(1.0) - expected));
  }
  return worst;
}

void check_family(std::filesystem::path const& path) {
  std::ifstream file(path);
  REQUIRE(file);
  auto const family = nlohmann::json::parse(file);
  REQUIRE_FALSE(family.at("cases").empty());
  for (auto const& item : family.at("cases")) {
    for (Precision const precision : {Precision::quick, Precision::exact}) {
      Deviation const worst = deviation(item, precision);
      INFO(item.at("id") << ' ' << item.at("list"));
      CHECK(worst.response <= 1e-9);
      CHECK(worst.step <= 1e-9);
    }
  }
}

std::filesystem::path const source{AXISC_SOURCE_DIR};

}  // namespace

TEST_CASE("designs agree with the independent responses of the specification") {
  for (char const* family : {"axis_filter", "axis_filter_cascade", "add_interface"}) {
    auto const path = source / "../shared/reference" / (std::string(family) + ".json");
    if (std::filesystem::exists(path)) {
      check_family(path);
    } else {
      WARN("skipped, " << path.filename() << " is not here");
    }
  }
}

}  // namespace reference_responses_test
