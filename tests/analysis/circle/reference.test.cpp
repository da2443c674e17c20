// Recordings whose figures an independent program computed, made here again by their recipe.
#include "analysis/circle/causes.hpp"
#include "analysis/circle/deviations.hpp"
#include "simulated_circle.hpp"
#include "support/catch.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::circle::reference_test {
namespace {

using nlohmann::json;

SimulatedCircle machine_of(json const& given) {
  SimulatedCircle machine;
  machine.cycle = given["cycle_time_us"].get<double>() * 1e-6;
  machine.radius = given["radius_mm"];
  machine.feed_mm_per_min = given["feed_mm_per_min"];
  machine.turns = given["turns"];
  machine.centre = given["centre_mm"];
  machine.delay = given["delay_us"];
  for (auto& delay : machine.delay) delay *= 1e-6;
  machine.gain = given["gain"];
  machine.backlash = given["backlash_mm"];
  machine.spike = given["spike_mm"];
  machine.spike_time = given["spike_ms"].get<double>() * 1e-3;
  machine.squareness = given["squareness"];
  machine.resolution = given["resolution_mm"];
  return machine;
}

void check(json const& expected, double found, double tolerance) {
  CHECK(found == Approx(expected.get<double>()).epsilon(0).margin(tolerance));
}

TEST_CASE("figures and causes are those of an independent program") {
  auto const path = std::filesystem::path(AXISC_SOURCE_DIR) / "../shared/reference/circle.json";
  std::ifstream file(path);
  if (!file) {
    WARN("no reference figures at " << path.string() << ": skipped");
    return;
  }
  int count = 0;
  auto const cases = json::parse(file)["cases"];
  for (auto const& given : cases) {
    if (given["kind"] != "recording") continue;
    ++count;
    INFO(given["id"]);
    auto const machine = machine_of(given);
    std::vector<Turn> turns;
    for (auto const sense : {Sense::counterclockwise, Sense::clockwise}) {
      auto found = recorded_turns(machine.path(sense));
      REQUIRE(std::holds_alternative<std::vector<Turn>>(found));
      turns.push_back(std::get<std::vector<Turn>>(found).front());
    }
    double const radius = (turns[0].radius + turns[1].radius) / 2;
    auto const& expected = given["expected"];
    double const um = given["tolerance"]["um"];
    CHECK(turns[0].samples.size() == expected["points_per_turn"].get<std::size_t>());
    auto const deviations = deviations_of(turns, radius);
    check(expected["circular_deviation_um"]["ccw"], *deviations.counterclockwise, um);
    check(expected["circular_deviation_um"]["cw"], *deviations.clockwise, um);
    check(expected["bidirectional_circular_deviation_um"], *deviations.bidirectional, um);
    check(expected["mean_radial_deviation_um"], *deviations.mean_radial, um);
    check(expected["radial_deviation_um"]["max"], deviations.radial_max, um);
    check(expected["radial_deviation_um"]["min"], deviations.radial_min, um);
    check(expected["hysteresis_um"], *deviations.hysteresis, um);
    auto const causes = causes_of(turns, radius);
    REQUIRE(causes);
    auto const& wanted = expected["causes"];
    check(wanted["radius_um"], causes->radius, um);
    check(wanted["gain_difference"], causes->gain_difference, given["tolerance"]["gain"]);
    check(wanted["squareness_um_per_m"], causes->squareness * 1e6, um);
    check(wanted["delay_difference_us"], causes->delay_difference / machine.omega() * 1e6,
          given["tolerance"]["us"]);
    for (std::size_t i = 0; i < 2; ++i) {
      check(wanted["centre_um"][i], causes->centre.at(i), um);
      check(wanted["backlash_um"][i], causes->backlash.at(i), um);
      check(wanted["backlash_uncertainty_um"][i], causes->backlash_uncertainty.at(i), um);
    }
    constexpr std::array places{"ccw u+", "ccw v+", "ccw u-", "ccw v-", "cw u+", "cw v+", "cw u-", "cw v-"};
    for (std::size_t i = 0; i < places.size(); ++i) {
      check(wanted["spike_um"][places.at(i)], causes->spikes.at(i), um);
    }
    check(wanted["unexplained_rms_um"], causes->unexplained_rms, um);
    CHECK(causes->is_separable == given["backlash_and_friction_separable"].get<bool>());
  }
  CHECK(count > 0);
}

}  // namespace
}  // namespace axisc::circle::reference_test
