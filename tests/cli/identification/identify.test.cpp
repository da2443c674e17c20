// Mass and friction at the command line. The sample is simulated by another program,
// tests/analysis/tuning/axis_recordings.py: 360 kg, 150 N of Coulomb and 400 N/(m/s) of viscous friction,
// force two cycles late.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc::test;
using nlohmann::json;

namespace {

std::string sample() {
  return read_source_file("samples/resonance/moves.csv");
}

struct Bench {
  TemporaryFolder folder;

  Bench() {
    for (std::string const name : {"machine.json", "x.lis", "y.lis", "z.lis", "moves.csv"}) {
      folder.write(name, read_source_file("samples/resonance/" + name));
    }
  }
  [[nodiscard]] Outcome run(std::vector<std::string> more) const {
    more.insert(more.begin(), {"identify", "machine.json"});
    return run_axisc(more, in_folder(folder.path()));
  }
  [[nodiscard]] json answer(std::vector<std::string> more) const {
    more.insert(more.end(), {"--axis", "X", "--format", "json"});
    auto const outcome = run(more);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out);
  }
  void check_refused(std::vector<std::string> more, std::string const& what) const {
    more.insert(more.end(), {"--axis", "X"});
    auto const outcome = run(more);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(what) != std::string::npos);
  }
};

json row(json const& answer, std::string const& quantity) {
  for (auto const& one : answer["estimates"]) {
    if (one["quantity"] == quantity) return one;
  }
  FAIL("no " << quantity);
  return {};
}

/// The sample with other names, its two columns multiplied.
std::string changed(std::string const& names, double position, double force) {
  std::istringstream lines(sample());
  std::ostringstream made;
  made.precision(12);
  made << names << "\n";
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    auto const first = line.find(',');
    auto const second = line.find(',', first + 1);
    made << line.substr(0, first) << "," << position * std::stod(line.substr(first + 1)) << ","
         << force * std::stod(line.substr(second + 1)) << "\n";
  }
  return made.str();
}

}  // namespace

TEST_CASE("identify finds mass and friction of the sample", "[identify]") {
  Bench const bench;
  auto const found = bench.answer({"moves.csv"});
  struct Truth {
    char const* quantity;
    double value;
    char const* unit;
  };
  for (auto const& truth : {Truth{"mass", 360, "kg"}, Truth{"coulomb_friction", 150, "N"},
                            Truth{"viscous_friction", 400, "N/(m/s)"}, Truth{"constant_force", 0, "N"}}) {
    auto const one = row(found, truth.quantity);
    CAPTURE(truth.quantity);
    CHECK(one["unit"] == truth.unit);
    if (!one["given"].get<bool>()) continue;
    CHECK(std::abs(one["value"].get<double>() - truth.value) <= one["uncertainty"].get<double>());
  }
  CHECK(row(found, "mass")["value"].get<double>() == Approx(360).epsilon(0.02));
  CHECK(row(found, "coulomb_friction")["given"] == true);
  CHECK(found["dead_time_ms"] == 2);
  CHECK(found["mapping"][1]["column"] == "Force X [N]");
  for (std::string const language : {"en", "de"}) {
    auto const text = bench.run({"moves.csv", "--axis", "X", "--lang", language});
    CHECK(text.status == 0);
    check_golden("tests/cli/identification/data/identified." + language + ".text", text.out);
  }
}

TEST_CASE("identify gives mass and friction in the unit of the force", "[identify]") {
  Bench const bench;
  auto const compare = [&](std::string const& names, double position, double force, std::string const& mass,
                           double value) {
    CAPTURE(names);
    bench.folder.write("other.csv", changed(names, position, force));
    auto const one = row(bench.answer({"other.csv"}), "mass");
    CHECK(one["unit"] == mass);
    CHECK(one["value"].get<double>() == Approx(value).epsilon(0.02));
  };
  compare("time,Position X [mm],Force X [kN]", 1, 0.001, "kg", 360);
  compare("time,Position X [µm],Force X [N]", 1000, 1, "kg", 360);
  compare("time,Position X [mm],Torque X [Nm]", 1, 0.01, "Nm/(m/s²)", 3.6);
  compare("time,Position X [mm],Current X [A]", 1, 0.1, "A/(m/s²)", 36);
  compare("time,Position X [mm],Torque X", 1, 0.1, "F/(m/s²)", 36);
}

TEST_CASE("identify of a rotary axis is an inertia", "[identify]") {
  Bench const bench;
  bench.folder.write("c.lis", "kenngr.achs_typ 2\nfilter_fir.enable 0\nEnde\n");
  bench.folder.write("rotary.json", R"({"machine": "m", "cycle_time_us": 1000,
      "axes": [{"name": "C", "list": "c.lis", "type": "R"}]})");
  bench.folder.write("turns.csv", changed("time,Position C [°],Torque C [Nm]", 1, 1));
  auto const outcome =
      run_axisc({"identify", "rotary.json", "turns.csv", "--format", "json"}, in_folder(bench.folder.path()));
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  auto const one = row(json::parse(outcome.out), "mass");
  CHECK(one["unit"] == "kg m²");
  // 360 N/(m/s²) with mm read as degrees: F = 0.36 a in mm/s², so 0.36 · 180/π in rad/s².
  CHECK(one["value"].get<double>() == Approx(0.36 * 57.29578).epsilon(0.02));
}

TEST_CASE("identify asks what is not clear", "[identify]") {
  Bench const bench;
  bench.folder.write("unnamed.csv", changed("time,a,b", 1, 1));
  bench.check_refused({"unnamed.csv"}, "--actual COLUMN; there are \"a\", \"b\"");
  bench.check_refused({"unnamed.csv", "--actual", "a"}, "--force COLUMN");
  auto const guessed = bench.answer({"unnamed.csv", "--actual", "a", "--force", "b"});
  CHECK(guessed["position_unit_guessed"] == true);
  CHECK(bench.answer({"moves.csv"})["position_unit_guessed"] == false);
  auto const named = bench.answer({"unnamed.csv", "--actual", "a", "--force", "b", "--unit", "mm"});
  CHECK(named["mapping"][0]["found_by"] == "option");
  bench.folder.write("two.csv", changed("time,Position [mm],Torque A [Nm]", 1, 1));
  CHECK(bench.answer({"two.csv"})["mapping"][0]["found_by"] == "name");
  bench.check_refused({}, "a recording of the axis is missing");
  bench.folder.write("other.csv", changed("time,Position X [mm],Torque X [Nm]", 1, 1));
  bench.check_refused({"moves.csv", "other.csv"}, "another unit");
  auto const outcome = bench.run({"moves.csv"});
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("machine.json has the axes X, Y, Z: name one with --axis") != std::string::npos);
}

TEST_CASE("identify refuses with a reason and what to record", "[identify]") {
  Bench const bench;
  auto const text = sample();
  std::size_t end = 0;
  for (int i = 0; i < 500; ++i) end = text.find('\n', end) + 1;
  bench.folder.write("short.csv", text.substr(0, end));
  bench.check_refused({"short.csv"}, "short.csv: too short");
  bench.check_refused({"short.csv", "--lang", "de"}, "zu kurz: Die Achse muss sich");
  bench.folder.write("still.csv", changed("time,Position X [mm],Force X [N]", 0, 1));
  bench.check_refused({"still.csv"}, "does not move");
  auto const together = bench.answer({"moves.csv", "moves.csv"});
  CHECK(row(together, "mass")["value"].get<double>() == Approx(360).epsilon(0.02));
}

TEST_CASE("identify writes a plant file, or says which keys are missing", "[identify]") {
  Bench const bench;
  std::vector<std::string> emit{"moves.csv", "--emit", "plant"};
  auto const with = [&](std::vector<std::string> const& known) {
    auto words = emit;
    for (auto const& one : known) words.insert(words.end(), {"--known", one});
    return words;
  };
  bench.check_refused(emit, "motor_mass_kg, load_mass_kg, stiffness_n_per_um");
  std::vector<std::string> known{"stiffness_n_per_um=4.55", "damping_n_s_per_mm=0.6",
                                 "velocity_bandwidth_hz=20", "kv_per_s=30", "load_mass_kg=60"};
  auto words = with(known);
  words.insert(words.end(), {"--axis", "X"});
  auto const outcome = bench.run(words);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(schema_complaints(outcome.out, read_source_file("docs/schemas/plant.schema.json")) ==
        std::vector<std::string>());
  auto const plant = json::parse(outcome.out)["plants"][0];
  CHECK(plant["motor_mass_kg"].get<double>() == Approx(300).epsilon(0.03));
  CHECK(plant["load_mass_kg"] == 60);
  bench.folder.write("plant.json", outcome.out);
  auto const simulated =
      run_axisc({"simulate", "machine.json", "--plant", "plant.json", "--move", "X:50:6000"},
                in_folder(bench.folder.path()));
  INFO(simulated.err);
  CHECK(simulated.status == 0);
  known.back() = "load_mass_kg=400";
  bench.check_refused(with(known), "leave nothing of the");
  known.insert(known.end(), "motor_mass_kg=300");
  bench.check_refused(with(known), "leave one out");
  bench.check_refused(with({"mass=3"}), "\"mass\" is not a key");
  bench.check_refused(with({"kv_per_s=0"}), "above 0");
  bench.check_refused(with({"kv_per_s"}), "KEY=VALUE");
  bench.check_refused(with({"position_feedback=load"}), "direct, motor");
  bench.check_refused({"moves.csv", "--known", "kv_per_s=3"}, "--emit");
  bench.folder.write("unnamed.csv", changed("time,actual,torque [N]", 1, 1));
  bench.check_refused({"unnamed.csv", "--emit", "plant"}, "say it with --unit");
}

TEST_CASE("identify's plant file takes Kv from the list", "[identify]") {
  Bench const bench;
  bench.folder.write("x.lis", "getriebe[0].kv 3000\n" + read_source_file("samples/resonance/x.lis"));
  bench.check_refused({"moves.csv", "--emit", "plant"}, "name=X, kv_per_s=30");
}
