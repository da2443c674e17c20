#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

namespace simulate_plant_test {

using namespace axisc::test;

namespace {

std::string const rack = std::string(AXISC_SOURCE_DIR) + "/samples/motion/rack/";

/// The sample with every weight multiplied.
nlohmann::json with_weights(TemporaryFolder const& folder, std::string const& denominator) {
  std::ifstream in(rack + "x.lis");
  std::string list;
  for (std::string line; std::getline(in, line);) {
    if (line.find("weight_fact_denom") != std::string::npos) {
      line = line.substr(0, line.find(' ')) + " " + denominator;
    }
    list += line + "\n";
  }
  folder.write("x.lis", list);
  folder.write("m.json",
               R"({"machine": "m", "cycle_time_us": 1000,
                   "axes": [{"name": "X", "list": "x.lis", "drive": "SERCOS", "position_control": "drive"}]})");
  auto const outcome = run_axisc(
      {"simulate", "m.json", "--plant", rack + "plant.json", "--move", "X:800:31800", "--format", "json"},
      in_folder(folder.path()));
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.out);
}

}  // namespace

TEST_CASE("the manual's damping: 53 Hz directly, 11 Hz indirectly, both at once") {
  auto const outcome = run_axisc({"simulate", rack + "machine.json", "--plant", rack + "plant.json", "--move",
                                  "X:800:31800", "--format", "json"});
  REQUIRE(outcome.status == 0);
  auto const found = nlohmann::json::parse(outcome.out);
  auto const& travel = found["oscillations"][0];
  auto const& rest = found["oscillations"][1];
  CHECK(travel["frequency_hz"].get<double>() == Approx(53).margin(0.5));
  CHECK(travel["amplitude_without_m_per_s2"].get<double>() == Approx(0.81).margin(0.02));
  CHECK(travel["amplitude_with_m_per_s2"].get<double>() <= 0.40);
  CHECK(rest["frequency_hz"].get<double>() == Approx(11).margin(0.5));
  CHECK(rest["amplitude_without_m_per_s2"].get<double>() == Approx(0.52).margin(0.02));
  CHECK(rest["amplitude_with_m_per_s2"].get<double>() <= 0.28);
  CHECK(found["diverges"] == false);
  CHECK(found["limit_hit"] == false);
  // The drive follows up to more than this plant's search tries.
  CHECK(found["highest_kv_without_per_s"].is_null());
  CHECK(found["kv_searched_to_per_s"] == 1000);
  CHECK_THAT(
      run_axisc({"simulate", rack + "machine.json", "--plant", rack + "plant.json", "--move", "X:800:31800"})
          .out,
      Catch::Matchers::Contains(
          "highest Kv without oscillation: above 1000 1/s without, above 1000 1/s with\n"
          "Improved Position Control\n"));
}

TEST_CASE("a function without effect leaves every figure as it is") {
  TemporaryFolder const folder;
  auto const found = with_weights(folder, "4000000000");
  REQUIRE(found["oscillations"].size() == 2);
  for (auto const& phase : found["oscillations"]) {
    CHECK(phase["amplitude_with_m_per_s2"].get<double>() ==
          Approx(phase["amplitude_without_m_per_s2"].get<double>()).epsilon(1e-5));
  }
}

TEST_CASE("without an active stage nothing is compared") {
  TemporaryFolder const folder;
  folder.write("x.lis", "getriebe[0].dynamik.vb_max 500000\ngetriebe[0].dynamik.a_max 3000\n");
  folder.write("m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}]})");
  auto const plant = [&](std::string const& kv, std::string const& bandwidth) {
    folder.write(
        "p.json",
        R"({"plants": [{"name": "X", "motor_mass_kg": 500, "load_mass_kg": 800, "stiffness_n_per_um": 90,
                     "damping_n_s_per_mm": 8, "dead_time_us": 2000, "velocity_bandwidth_hz": )" +
            bandwidth + R"(, "kv_per_s": )" + kv + "}]}");
    return run_axisc({"simulate", "m.json", "--plant", "p.json", "--move", "X:300"}, in_folder(folder.path()))
        .out;
  };
  using Catch::Matchers::Contains;
  auto const calm = plant("20", "50");
  CHECK_THAT(calm, Contains("no active Improved Position Control") && !Contains("travelling") &&
                       !Contains("with Improved Position Control"));
  CHECK_THAT(calm, Contains("highest Kv without oscillation: "));
  auto const wild = plant("900", "50");
  CHECK_THAT(wild, Contains("DIVERGES") && Contains("lower kv_per_s") && !Contains("weights"));
}

TEST_CASE("weights raised far enough make the loop diverge, and the command says so") {
  TemporaryFolder const folder;
  auto const found = with_weights(folder, "20");
  CHECK(found["diverges"] == true);
  CHECK(found["diverges_without"] == false);
  CHECK_THAT(run_axisc({"simulate", "m.json", "--plant", rack + "plant.json", "--move", "X:800:31800"},
                       in_folder(folder.path()))
                 .out,
             Catch::Matchers::Contains("DIVERGES"));
}

TEST_CASE("the record of a loop as CSV") {
  TemporaryFolder const folder;
  auto const outcome = run_axisc({"simulate", rack + "machine.json", "--plant", rack + "plant.json", "--move",
                                  "X:-50", "--output", folder / "loop.csv", "--lang", "de"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("höchstes Kv ohne Schwingung"));
  CHECK_THAT(folder.read("loop.csv"), Catch::Matchers::StartsWith("time_s,setpoint_mm,load_without_mm,"));
}

TEST_CASE("mistakes of plant files and moves") {
  TemporaryFolder const folder;
  auto const error = [&](std::string const& plant, std::string const& move = "X:10") {
    folder.write("p.json", plant);
    auto const outcome =
        run_axisc({"simulate", rack + "machine.json", "--plant", folder / "p.json", "--move", move});
    CHECK(outcome.status == 2);
    return outcome.err;
  };
  CHECK_THAT(error("[1"), Catch::Matchers::Contains("AX9009") &&
                              Catch::Matchers::Contains("p.json:1:3: the plant file is not valid JSON"));
  CHECK_THAT(error("[]"), Catch::Matchers::Contains("AX9009") &&
                              Catch::Matchers::Contains("an object in braces is expected"));
  CHECK_THAT(error("{}"), Catch::Matchers::Contains("\"plants\" is missing"));
  CHECK_THAT(error(R"({"plants": []})"), Catch::Matchers::Contains("no plant for axis X"));
  CHECK_THAT(error(R"({"plants": [{"name": "X"}]})"),
             Catch::Matchers::Contains("\"motor_mass_kg\" is missing"));
  CHECK_THAT(error(R"({"plants": [{"name": "X", "motor_mass_kg": -1}]})"),
             Catch::Matchers::Contains("must be a number > 0"));
  CHECK_THAT(
      error(R"({"plants": [{"name": "X", "motor_mass_kg": 1, "load_mass_kg": 1, "stiffness_n_per_um": 1,
                       "damping_n_s_per_mm": 1, "velocity_bandwidth_hz": 9, "kv_per_s": 1, "mass": 2}]})"),
      Catch::Matchers::Contains("p.json:2:92: unknown key \"mass\""));
  for (std::string const move : {"X", "X:0", "X:a", ":5", "X:5:0", "Q:5"}) {
    static_cast<void>(error("{}", move));
  }
  // 800 mm at 1 nm/min.
  auto const slow = run_axisc(
      {"simulate", rack + "machine.json", "--plant", rack + "plant.json", "--move", "X:800:0.000001"});
  CHECK(slow.status == 2);
  CHECK_THAT(slow.err, Catch::Matchers::Contains("NC cycles"));
}

}  // namespace simulate_plant_test
