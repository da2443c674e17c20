// Vibration Guard in lists and programs, beside its formulas written out (spec "vibration guard", section 2).
#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

#include <nlohmann/json.hpp>

namespace vibration_guard_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

constexpr double D = 0.1;
double const root = std::sqrt(1 - D * D);
double const K = std::exp(-std::numbers::pi * D / root);
double const half_period = 1 / (2 * 30 * root);  // s

/// Two axes with one list; 500 mm/s, 10 m/s².
Surroundings machine(TemporaryFolder const& folder, std::string const& list, std::string const& more = "") {
  folder.write("a.lis", list +
                            "getriebe[0].dynamik.vb_max 500000\ngetriebe[0].dynamik.a_max 10000\n"
                            "getriebe[0].lslope_profil.a_stufe_1 10000\n"
                            "getriebe[0].lslope_profil.a_stufe_2 10000\nEnde\n");
  folder.write("m.json", R"({"machine": "m", "cycle_time_us": 1000, )" + more +
                             R"("axes": [{"name": "X", "list": "a.lis"}, {"name": "Y", "list": "a.lis"}]})");
  return in_folder(folder.path());
}

std::string guard(int mode) {
  return "vib_guard.active 1\nvib_guard.mode " + std::to_string(mode) +
         "\nvib_guard.freq 30\nvib_guard.damping 0.1\n";
}

nlohmann::json answer(Surroundings const& there, std::vector<std::string> words) {
  words.insert(words.end(), {"--format", "json"});
  auto const outcome = run_axisc(words, there);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.out);
}

/// The column of X.
std::vector<double> column(std::string const& csv) {
  std::istringstream lines(csv);
  std::vector<double> values;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) values.push_back(std::stod(line));
  return values;
}

/// A split impulse train's answer to a step of 1 in cycle n.
double step_answer(std::vector<double> const& amplitudes, int cycle) {
  double sum = 0;
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    double const x = static_cast<double>(i) * half_period * 1e3;
    double const part = x - std::floor(x);
    if (cycle >= std::floor(x)) sum += amplitudes[i] * (cycle > std::floor(x) ? 1 : 1 - part);
  }
  return sum;
}

}  // namespace

TEST_CASE("a guard of the lists works from start-up, one of a program from its command") {
  TemporaryFolder const folder;
  std::vector<double> const zvd{1 / ((1 + K) * (1 + K)), 2 * K / ((1 + K) * (1 + K)),
                                K * K / ((1 + K) * (1 + K))};
  auto const check = [&](Surroundings const& there, std::vector<std::string> const& more) {
    REQUIRE(run_axisc({"compile", "m.json", "-o", "m.axim", "--quiet"}, there).status == 0);
    std::vector<std::string> words{"run", "m.axim", "--signal", "step", "--cycles", "60"};
    words.insert(words.end(), more.begin(), more.end());
    auto const outcome = run_axisc(words, there);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    auto const found = column(outcome.out);
    REQUIRE(found.size() == 60);
    for (int n = 0; n < 60; ++n) {
      CHECK(std::abs(found[static_cast<std::size_t>(n)] - step_answer(zvd, n)) < 1e-9);
    }
  };
  check(machine(folder, guard(2)), {});
  auto const commanded = machine(folder, "", R"("filter_sets": ["#VIB GUARD ON [MODE=2]"], )");
  check(commanded, {"--at", "0:#VIB GUARD ON [MODE=2]"});
  auto const without = column(run_axisc({"run", "m.axim", "--cycles", "3"}, commanded).out);
  CHECK(without == std::vector<double>(3, 1.0));
}

TEST_CASE("an image with a guard has format 1.2, any other without bounds 1.1") {
  TemporaryFolder const folder;
  auto const there = machine(folder, guard(4));
  REQUIRE(run_axisc({"compile", "m.json", "-o", "m.axim", "--quiet"}, there).status == 0);
  auto const found = answer(there, {"inspect", "m.axim"});
  CHECK(found["format"]["minor"] == 2);
  auto const& slot = found["axes"][0]["linear_phase_filter"];
  CHECK(slot["family"] == "VIB GUARD");
  CHECK(slot["path"] == "vib_guard");
  auto const& figures = found["axes"][0]["vibration_guard"];
  CHECK(figures["mode"] == 4);
  CHECK(figures["impulses_ms"][1].get<double>() == Approx(1e3 * half_period));
  CHECK(figures["impulses_percent"][1].get<double>() == Approx(100 * (1 + K * K) / ((1 + K) * (1 + K))));
  CHECK(figures["interval_lowest_percent"].get<double>() == Approx(-10.6136).margin(0.01));
  CHECK(figures["interval_highest_percent"].get<double>() == Approx(13.7641).margin(0.01));
  CHECK_THAT(run_axisc({"inspect", "m.axim"}, there).out,
             Contains("Vibration Guard") && Contains("vib_guard, works from start-up") &&
                 Contains("at most 5 % left") && !Contains("setpoints pass unchanged"));
  machine(folder, "");
  REQUIRE(run_axisc({"compile", "m.json", "-o", "m.axim", "--no-bounds", "--quiet"}, there).status == 0);
  CHECK(answer(there, {"inspect", "m.axim"})["format"]["minor"] == 1);
}

TEST_CASE("corners of a guard in closed form") {
  TemporaryFolder const folder;
  auto const corner = [&](int mode) {
    auto const there = machine(folder, guard(mode));
    auto const found = answer(there, {"contour", "m.json", "--feed", "1000"});
    for (auto const& row : found["groups"][0]["table"]) {
      if (row["contour"] == "corner") return row;
    }
    return nlohmann::json();
  };
  double const travel = 1000.0 / 60 * 1e3 * half_period;  // µm in half a period
  double const A1 = 1 / (1 + K), A2 = K / (1 + K);
  auto const first = corner(1);
  INFO(first);
  CHECK(first["contour_deviation_um"].get<double>() ==
        Approx(travel * A1 * A2 / std::hypot(A1, A2)).margin(0.01));
  auto const fourth = corner(4);
  double const error = travel * K / ((1 + K) * (1 + K));
  CHECK(fourth["max_axis_error_um"].get<double>() == Approx(error).margin(0.01));
  CHECK(fourth["contour_deviation_um"].get<double>() == Approx(error * std::numbers::sqrt2).margin(0.01));
}

TEST_CASE("the slave of a gantry is guarded as its master") {
  TemporaryFolder const folder;
  folder.write("x.lis", "vib_guard.mode 3\nvib_guard.freq 25\nEnde\n");
  folder.write("x2.lis", "vib_guard.mode 1\nEnde\n");
  folder.write("y.lis", "Ende\n");
  folder.write("m.json", R"({"cycle_time_us": 1000, "filter_sets": ["#VIB GUARD ON [FREQ=20]"],
      "axes": [{"name": "X", "list": "x.lis"}, {"name": "X2", "list": "x2.lis"}, {"name": "Y", "list": "y.lis"}],
      "groups": [{"name": "mill", "axes": ["X", "Y"]}], "gantries": [{"master": "X", "slaves": ["X2"]}]})");
  auto const there = in_folder(folder.path());
  REQUIRE(run_axisc({"compile", "m.json", "-o", "m.axim", "--quiet"}, there).status == 0);
  for (std::string const command : {"#VIB GUARD ON", "#VIB GUARD ON [FREQ=20]"}) {
    auto const outcome = run_axisc({"run", "m.axim", "--cycles", "120", "--at", "0:" + command}, there);
    REQUIRE(outcome.status == 0);
    std::istringstream lines(outcome.out);
    std::string line;
    std::getline(lines, line);
    CHECK(line == "X,X2,Y");
    while (std::getline(lines, line)) {
      auto const end = line.find(',');
      CHECK(line.substr(0, end) == line.substr(end + 1, line.find(',', end + 1) - end - 1));
    }
  }
}

TEST_CASE("a command asks for guards that no list has") {
  TemporaryFolder const folder;
  auto const there = machine(folder, "");
  auto const found =
      answer(there, {"contour", "m.json", "--feed", "1000", "--filter", "#VIB GUARD ON [MODE=2]"});
  auto const& corner = found["groups"][0]["table"][0];
  CHECK(corner["contour"] == "corner");
  CHECK(corner["contour_deviation_um"].get<double>() == Approx(106.37).margin(0.01));
}

TEST_CASE("a program's guards keep AX_DEV until a command does not name it") {
  TemporaryFolder const folder;
  auto const there = machine(folder, "");
  folder.write("p.nc",
               "N10 #VIB GUARD ON [MODE=2 FREQ=40 AX_DEV=0.01]\nN20 G01 X50 F6000\nN30 Y50\n"
               "N40 #VIB GUARD [FREQ=35]\nN50 X0\nN60 Y0\nN70 #VIB GUARD OFF\nN80 X50\nN90 Y50\nM30\n");
  auto const found = answer(there, {"simulate", "m.json", "--program", "p.nc"});
  auto const& passes = found["passes"];
  REQUIRE(passes.size() == 3);
  CHECK(passes[0]["max_axis_error_um"].get<double>() <= 10);
  CHECK(passes[0]["max_axis_error_um"].get<double>() > 9);
  CHECK(passes[1]["max_axis_error_um"].get<double>() > 10);
  CHECK(passes[2]["max_axis_error_um"] == 0);
  CHECK(passes[1]["command"] == "#VIB GUARD [FREQ=35]");
}

TEST_CASE("a recording names the guard's commands as programs write them") {
  TemporaryFolder const folder;
  auto const there = machine(folder, guard(1), R"("filter_sets": ["#VIB GUARD ON [MODE=2 FREQ=41.5]"], )");
  REQUIRE(run_axisc({"compile", "m.json", "-o", "m.axim", "--quiet"}, there).status == 0);
  REQUIRE(run_axisc({"run", "m.axim", "--cycles", "900", "--at", "3:#VIB GUARD ON [MODE=2 FREQ=41.5]", "--at",
                     "800:#VIB GUARD OFF", "--record", "r.axrd", "-o", "run.csv"},
                    there)
              .status == 0);
  auto const replayed = run_axisc({"replay", "m.axim", "r.axrd"}, there);
  CHECK(replayed.status == 0);
  CHECK_THAT(replayed.out, Contains("#VIB GUARD ON [MODE=2 FREQ=41.5]") && Contains("#VIB GUARD OFF"));
}

TEST_CASE("a guard that is too long to be compiled is an error, one of more than 200 cycles a note") {
  TemporaryFolder const folder;
  auto const lint = [&](std::string const& frequency, std::vector<std::string> const& more) {
    auto const there =
        machine(folder, "vib_guard.active 1\nvib_guard.mode 3\nvib_guard.freq " + frequency + "\n");
    std::vector<std::string> words{"lint", "m.json"};
    words.insert(words.end(), more.begin(), more.end());
    return run_axisc(words, there);
  };
  auto const long_one = lint("1.2", {});
  CHECK(long_one.status == 1);
  CHECK_THAT(long_one.out, Contains("error[AX3027]") && Contains("960"));
  CHECK(lint("5", {}).status == 0);
  CHECK_THAT(lint("5", {}).out, !Contains("AX3027"));
  CHECK_THAT(lint("5", {"--pedantic"}).out, Contains("note[AX3027]"));
}

TEST_CASE("a guard that cannot be is said, in lists and in commands") {
  TemporaryFolder const folder;
  auto const there = machine(folder, "vib_guard.active 1\nvib_guard.damping 1\n");
  CHECK_THAT(run_axisc({"lint", "m.json"}, there).err + run_axisc({"lint", "m.json"}, there).out,
             Contains("AX3026"));
  auto const good = machine(folder, guard(1));
  REQUIRE(run_axisc({"compile", "m.json", "-o", "m.axim", "--quiet"}, good).status == 0);
  auto const refused = run_axisc({"run", "m.axim", "--at", "0:#VIB GUARD ON [DAMPING=1]"}, good);
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Contains("there is no oscillation"));
  auto const unknown = run_axisc({"run", "m.axim", "--at", "0:#VIB GUARD ON [MODE=3]"}, good);
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.err, Contains("Name `#VIB GUARD ON [MODE=3]` in filter_sets"));
}

}  // namespace vibration_guard_test
