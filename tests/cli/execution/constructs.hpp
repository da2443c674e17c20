// The programs of samples/motion/constructs: what each construct of NC programs does, against figures by
// hand. X and Y have 500 mm/s and 10 m/s², Z has 250 mm/s and 5 m/s².
#pragma once

#include "cli/program.hpp"
#include "support/catch.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::test {

inline Outcome run_construct(std::string const& program, std::vector<std::string> const& more) {
  std::vector<std::string> words = {"simulate", "machine.json", "--program", program, "--color", "never"};
  words.insert(words.end(), more.begin(), more.end());
  return run_axisc(words, in_folder(std::string(AXISC_SOURCE_DIR) + "/samples/motion/constructs"));
}

inline nlohmann::json simulated_construct(std::string const& program) {
  auto const outcome = run_construct(program, {"--format", "json"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.out);
}

struct TimedBlock {
  std::string label;
  double seconds = 0;
};

inline void check_times(nlohmann::json const& found, std::vector<TimedBlock> const& expected) {
  REQUIRE(found["blocks"].size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    auto const& block = found["blocks"][i];
    INFO(expected[i].label << ", block " << i);
    CHECK(block["block"] == expected[i].label);
    CHECK(block["time_s"].get<double>() == Approx(expected[i].seconds).margin(1e-6));
  }
}

inline void check_deviations(nlohmann::json const& found, std::vector<double> const& expected_um) {
  REQUIRE(found["blocks"].size() == expected_um.size());
  for (std::size_t i = 0; i < expected_um.size(); ++i) {
    auto const& block = found["blocks"][i];
    INFO(block["block"]);
    CHECK(block["max_contour_deviation_um"].get<double>() ==
          Approx(expected_um[i]).epsilon(1e-6).margin(1e-9));
  }
}

/// From rest to rest along L mm with v mm/s and a mm/s², long enough to reach v: L/v + v/a.
inline double rest_to_rest(double L, double v = 10, double a = 10000) {
  return L / v + v / a;
}

}  // namespace axisc::test
