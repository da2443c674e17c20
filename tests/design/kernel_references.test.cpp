// Kernels against independent responses: complex frequency response and step response within 1e-9.
#include "design/kernels/kernel_analysis.hpp"
#include "design/kernels/kernel_design.hpp"
#include "support/catch.hpp"
#include "tests/design/kernel_filter.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

namespace kernel_references_test {

namespace {

using namespace axisc::design;

KernelType type_numbered(int number) {
  switch (number) {
    case 2: return KernelType::gaussian;
    case 3: return KernelType::windowed_sinc;
    case 4: return KernelType::time_delay;
    case 12: return KernelType::novib;
    default: return KernelType::moving_average;  // 1, and 8 of the HSC filters
  }
}

/// From lines such as "filter_fir.order 20" or "filter[0].share_percent 88.9".
KernelSpecification specification_of(nlohmann::json const& lines, CycleTime cycle_time) {
  KernelSpecification specification;
  for (std::string const line : lines) {
    std::istringstream words(line.substr(line.find('.') + 1));
    std::string parameter, text;
    words >> parameter >> text;
    if (parameter == "prototype" || parameter == "enable") continue;
    double const value = std::stod(text);
    if (parameter == "type") specification.type = type_numbered(static_cast<int>(value));
    if (parameter == "order") specification.order = static_cast<std::uint32_t>(value);
    if (parameter == "order_time" || parameter == "time_constant")
      specification.order = order_of_time({value}, cycle_time).value_or(0);
    if (parameter == "fcut" || parameter == "fg_f0") specification.frequency = {value};
    if (parameter == "quality") specification.quality = value;
    if (parameter == "share" || parameter == "share_percent") specification.share_percent = value;
  }
  return specification;
}

void check_case(nlohmann::json const& item) {
  INFO(item.at("id") << ' ' << item.at("list"));
  CycleTime const cycle_time{item.at("cycle_time_us").get<std::uint32_t>() * 1000};
  KernelDesign const kernel = design_kernel(specification_of(item.at("list"), cycle_time), cycle_time);

  double worst = 0;
  auto const& frequencies = item.at("frequency_hz");
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    auto const expected =
        std::polar(item.at("magnitude").at(i).get<double>(), item.at("phase_rad").at(i).get<double>());
    ResponsePoint const point = kernel_response(kernel, {frequencies.at(i).get<double>()}, cycle_time);
    worst = std::max(worst, std::abs(std::polar(point.magnitude, point.phase_rad) - expected));
  }
  CHECK(worst <= 1e-9);

  KernelFilter filter(kernel);
  worst = 0;
  for (double const expected : item.at("step"))
    worst = std::max(worst, std::abs(filter.step(1.0) - expected));
  CHECK(worst <= 1e-9);
}

}  // namespace

TEST_CASE("kernels agree with the independent responses of the specification") {
  for (char const* family : {"fir", "hsc"}) {
    auto const path =
        std::filesystem::path(AXISC_SOURCE_DIR) / "../shared/reference" / (std::string(family) + ".json");
    std::ifstream file(path);
    if (!file) {
      WARN("skipped, " << path.filename() << " is not here");
      continue;
    }
    auto const cases = nlohmann::json::parse(file).at("cases");
    REQUIRE_FALSE(cases.empty());
    for (auto const& item : cases) check_case(item);
  }
}

}  // namespace kernel_references_test
