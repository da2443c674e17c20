// Against data/kernels.json, whose origin is data/make_kernels.py: every tap by its definition, in 60 digits.
#include "design/kernels/kernel_analysis.hpp"
#include "design/kernels/kernel_design.hpp"
#include "support/catch.hpp"

#include <complex>
#include <cstddef>
#include <fstream>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace kernel_independent_test {

namespace {

using namespace axisc::design;

std::map<std::string, KernelType> const kinds{{"moving_average", KernelType::moving_average},
                                              {"gaussian", KernelType::gaussian},
                                              {"windowed_sinc", KernelType::windowed_sinc},
                                              {"novib", KernelType::novib}};

}  // namespace

TEST_CASE("every kernel is the one of independent arithmetic, to the last bit") {
  std::ifstream file(AXISC_SOURCE_DIR "/tests/design/data/kernels.json");
  REQUIRE(file);
  auto const items = nlohmann::json::parse(file);
  REQUIRE(items.size() > 15);
  for (auto const& item : items) {
    KernelSpecification const specification{.type = kinds.at(item.at("kind")),
                                            .order = static_cast<std::uint32_t>(item.value("order", 1.0)),
                                            .frequency = {item.value("frequency", 30.0)},
                                            .quality = item.value("quality", 1.0),
                                            .share_percent = item.at("share")};
    CycleTime const cycle_time{item.at("cycle_time_us").get<std::uint32_t>() * 1000};
    KernelDesign const kernel = design_kernel(specification, cycle_time);
    INFO(item);
    REQUIRE(kernel.half_width == item.at("half_width").get<std::uint32_t>());
    for (auto const& tail_sum : item.at("tail_sums"))
      CHECK(kernel.tail_sums.at(tail_sum.at(0).get<std::size_t>()) == tail_sum.at(1).get<double>());
    for (auto const& point : item.at("response")) {
      std::complex<double> const expected{point.at(1).get<double>(), point.at(2).get<double>()};
      CHECK(std::abs(response(kernel, {point.at(0).get<double>()}, cycle_time) - expected) < 1e-13);
    }
  }
}

}  // namespace kernel_independent_test
