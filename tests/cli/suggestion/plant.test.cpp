// `axisc suggest --plant`: Improved Position Control of the rack in the samples.
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>

#include <nlohmann/json.hpp>

namespace plant_test {

using namespace axisc::test;

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The sample in a folder of its own, without any Improved Position Control, and beside an axis Y.
Surroundings rack(TemporaryFolder const& folder) {
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/motion/rack", folder.path());
  auto const list = folder.read("x.lis");
  auto const bare = list.substr(0, list.find("lr_param"));
  folder.write("x.lis", bare + "Ende\n");
  folder.write("y.lis", bare + "kopf.achs_nr 2\nEnde\n");
  auto machine = json::parse(folder.read("machine.json"));
  machine["axes"].push_back({{"name", "Y"}, {"list", "y.lis"}, {"drive", "SERCOS"}});
  folder.write("machine.json", machine.dump());
  return in_folder(folder.path());
}

Outcome suggest(Surroundings const& there, std::string const& resonance, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"suggest", "machine.json", "--axis", "X",     "--resonance", resonance,
                                     "--plant", "plant.json",   "--feed", "31800", "--radius",    "500"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_axisc(arguments, there);
}

json control_of(Outcome const& outcome) {
  INFO(outcome.err);
  return json::parse(outcome.out)["position_control"];
}

/// What `simulate` measures of the lists as they are: without and with the function.
json simulated(Surroundings const& there) {
  auto const outcome = run_axisc(
      {"simulate", "machine.json", "--plant", "plant.json", "--move", "X:800:31800", "--format", "json"},
      there);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("suggest writes Improved Position Control that damps what simulate shows") {
  TemporaryFolder const folder;
  auto const there = rack(folder);
  auto const y = folder.read("y.lis");
  auto const outcome = suggest(there, "53Hz,11Hz", {"--apply", "4", "--format", "json"});
  REQUIRE(outcome.status == 0);
  auto const control = control_of(outcome);
  CHECK(outcome.err.find("axisc: written: x.lis\n") != std::string::npos);
  CHECK(outcome.err.find("warning") != std::string::npos);  // no filter helps within 0.01 mm
  CHECK(json::parse(outcome.out)["alternatives"].empty());
  CHECK(control["findings"].empty());
  REQUIRE(control["axes"].size() == 2);
  CHECK(control["axes"][1] == json{{"axis", "Y"}, {"list", "y.lis"}, {"lines", json::array()}});
  CHECK(control["resonances"][1]["stage"] == 1);
  CHECK(folder.read("y.lis") == y);

  CHECK(run_axisc({"lint", "machine.json", "--pedantic"}, there).out == "3 files: no findings\n");
  auto const measured = simulated(there);
  for (auto const& oscillation : measured["oscillations"]) {
    CHECK(oscillation["amplitude_with_m_per_s2"].get<double>() <
          0.75 * oscillation["amplitude_without_m_per_s2"].get<double>());
  }
  CHECK(suggest(there, "11Hz", {"-o", "x.svg"}).err.find("nothing to draw") != std::string::npos);
  auto const again = suggest(there, "53Hz,11Hz", {"--apply", "4"});
  CHECK(again.err.find("nothing to write") != std::string::npos);
}

TEST_CASE("suggest says in two languages what Improved Position Control does") {
  TemporaryFolder const folder;
  auto const there = rack(folder);
  check_golden("tests/cli/data/golden/suggest_plant.de.text", suggest(there, "11Hz", {"--lang", "de"}).out);
  auto const absent = suggest(there, "25Hz,11Hz");
  CHECK(absent.out.find("no stage for 25 Hz: the plant does not resonate there") != std::string::npos);
}

TEST_CASE("stages that are not suggested are switched off") {
  TemporaryFolder const folder;
  auto const there = rack(folder);
  auto const list = folder.read("x.lis");
  std::string const stage = "lr_param.improved_position_control.stage[2].";
  folder.write("x.lis", "lr_param.improved_position_control.enable 1\n" + stage + "mode DIRECT\n" + stage +
                            "filter.order 1\n" + stage + "filter.fg_f0 90\n" + stage +
                            "filter.q_factor 5\nlr_param.improved_position_control.v_add_max_fact 10\n" +
                            list);
  CHECK(suggest(there, "11Hz", {"--apply", "4"}).status == 0);
  CHECK(folder.read("x.lis").find(stage + "mode NOT_ACTIVE\n") != std::string::npos);
  CHECK(run_axisc({"lint", "machine.json"}, there).out == "3 files: no findings\n");
}

TEST_CASE("lists that the check objects to are not written with Improved Position Control") {
  TemporaryFolder const folder;
  auto const there = rack(folder);
  auto list = folder.read("x.lis");
  for (std::string const name : {"antr.v_reso_num", "antr.v_reso_denom"}) list.insert(list.find(name), "# ");
  folder.write("x.lis", list);
  auto const outcome = suggest(there, "11Hz", {"--apply", "4", "--format", "json"});
  CHECK(outcome.status == 2);
  CHECK(control_of(outcome)["findings"] == json{"AX4016"});
  CHECK(outcome.err.find("AX4016") != std::string::npos);
  CHECK(folder.read("x.lis") == list);
}

TEST_CASE("suggest says why Improved Position Control does not help") {
  TemporaryFolder const folder;
  auto const there = rack(folder);
  auto const reason = [&](std::string const& resonance, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--format", "json"});
    return control_of(suggest(there, resonance, more))["refusal"];
  };
  CHECK(reason("25Hz") == "no_resonance");
  CHECK(suggest(there, "25Hz", {"--apply", "4"}).status != 0);
  CHECK(suggest(there, "25Hz").out.find("the plant of axis X in plant.json") != std::string::npos);
  CHECK(reason("53Hz", {"--feed", "600"}) == "still");

  auto const plant = folder.read("plant.json");
  auto harsh = json::parse(plant);
  harsh["plants"][0]["position_feedback"] = "direct";
  harsh["plants"][0]["kv_per_s"] = 900;
  folder.write("plant.json", harsh.dump());
  CHECK(reason("11Hz") == "diverges");
  folder.write("plant.json", plant);

  auto machine = json::parse(folder.read("machine.json"));
  machine["gantries"] = {{{"master", "X"}, {"slaves", {"Y"}}}};
  folder.write("machine.json", machine.dump());
  auto const gantry = suggest(there, "11Hz");
  INFO(gantry.err);
  CHECK(gantry.out.find("belongs to a gantry") != std::string::npos);
}

TEST_CASE("suggest refuses plants that are not there") {
  TemporaryFolder const folder;
  auto const there = rack(folder);
  auto const without =
      run_axisc({"suggest", "machine.json", "--axis", "X", "--resonance", "11Hz", "--apply", "4"}, there);
  CHECK(without.status == 2);
  CHECK(without.err.find("it needs --plant") != std::string::npos);
  auto const other = run_axisc(
      {"suggest", "machine.json", "--axis", "Y", "--resonance", "11Hz", "--plant", "plant.json"}, there);
  CHECK(other.status == 2);
  CHECK(other.err.find("no plant for axis Y") != std::string::npos);
}

}  // namespace plant_test
