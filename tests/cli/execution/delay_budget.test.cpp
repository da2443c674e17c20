// The worked examples of the delay budget, through the program.
#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace delay_budget_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

std::string const pt1 =
    "filter[0].type PT1\nfilter[0].enable 1\nfilter[0].order 1\nfilter[0].time_constant 4000\n";

/// Pre-warped: 1/(2 tan(T/2τ)).
double const pt1_cycles = 0.5 / std::tan(1.0 / 8);

/// X feeds its velocity forward, Y has the same filters and does not.
Surroundings machine(TemporaryFolder const& folder, std::string const& drive, std::string const& more = {}) {
  std::string const both = "kenngr.antr_typ " + drive + "\ngetriebe[0].dynamik.vb_max 66667\n" + pt1;
  folder.write("x.lis", both + "vorsteuer.vorsteuerung ADD_VEL\nvorsteuer.default_active 1\n" + more);
  folder.write("y.lis", "kopf.achs_nr 2\n" + both);
  folder.write("m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
      {"name": "Y", "list": "y.lis"}], "groups": [{"name": "mill", "axes": ["X", "Y"]}]})");
  return in_folder(folder.path());
}

Outcome budget(Surroundings const& there, std::vector<std::string> const& more) {
  std::vector<std::string> arguments{"contour", "m.json", "--budget"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  auto outcome = run_axisc(arguments, there);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return outcome;
}

}  // namespace

TEST_CASE("P, V and lead of a PROFIdrive axis, and what the difference between two axes costs") {
  TemporaryFolder const folder;
  auto const there = machine(folder, "3");
  auto const answer =
      nlohmann::json::parse(budget(there, {"--feed", "4000", "--format", "json"}).out)["delay_budget"];
  auto const& x = answer["axes"][0];
  CHECK(x["axis"] == "X");
  CHECK(x["position_ms"].get<double>() == Approx(pt1_cycles + 5));
  CHECK(x["velocity_cycles"].get<double>() == Approx(pt1_cycles + 2));
  CHECK(x["lead_cycles"].get<double>() == Approx(3));
  auto const& y = answer["axes"][1];
  CHECK(y["position_ms"].get<double>() == Approx(pt1_cycles));
  CHECK_FALSE(y.contains("lead_cycles"));
  // 5 ms apart at 4000 mm/min.
  CHECK(answer["channels"][0]["deviation_um"].get<double>() == Approx(166.67).margin(0.005));
  auto const text = budget(there, {"--feed", "4000"}).out;
  CHECK_THAT(text, Contains("5 ms apart") && Contains("166.7 µm") && Contains("before its position") &&
                       Contains("P-AXIS-00165"));
  CHECK_THAT(budget(there, {"--lang", "de"}).out, Contains("Verzögerungsbilanz") && Contains("Lesart"));
  CHECK_THAT(budget(there, {"--format", "csv"}).out,
             Contains("X,start,vorsteuer.shift_time,0,-3,-3,-3,P-AXIS-00165,default,documented"));
}

TEST_CASE("a velocity that arrives late, and one that arrives with its position") {
  TemporaryFolder const folder;
  auto const late = machine(folder, "2", "vorsteuer.velocity_delay_time 1500\n");
  CHECK_THAT(budget(late, {}).out, Contains("1.5 ms") && Contains("after its position"));
  auto const together = machine(folder, "2");
  CHECK_THAT(budget(together, {}).out, Contains("both arrive together"));
}

TEST_CASE("lint states the lead and the difference in milliseconds and µm") {
  TemporaryFolder const folder;
  auto const there = machine(folder, "3");
  auto const lead = run_axisc({"lint", "x.lis", "--alone", "--cycle-time", "1ms", "--pedantic"}, there);
  CHECK_THAT(lead.out, Contains("AX4025") && Contains("leads its position by 3 cycles (3 ms)") &&
                           Contains("accounts for 3 cycles by default"));
  auto const difference = run_axisc({"lint", "m.json"}, there);
  CHECK_THAT(difference.out, Contains("AX4024") && Contains("by 5 cycles (5 ms)") && Contains("166.66"));
}

TEST_CASE("options of predictions mean nothing to the budget") {
  TemporaryFolder const folder;
  auto const there = machine(folder, "3");
  auto const outcome = run_axisc({"contour", "m.json", "--budget", "--order", "20"}, there);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--order") && Contains("--budget"));
}

TEST_CASE("contour and simulate contain what delays positions after the filters") {
  TemporaryFolder const folder;
  std::string const dynamics =
      "getriebe[0].dynamik.vb_max 500000\ngetriebe[0].dynamik.a_max 10000\n"
      "getriebe[0].lslope_profil.a_stufe_1 10000\ngetriebe[0].lslope_profil.a_stufe_2 10000\nEnde\n";
  std::string const forward = "vorsteuer.vorsteuerung VEL\nvorsteuer.default_active 1\n";
  folder.write("x.lis", forward + dynamics);
  folder.write("y.lis", dynamics);
  folder.write("p.nc", "N10 G01 X70 Y70 F4000\nM30\n");
  auto const pair = [&](std::string const& second) {
    folder.write("m.json", R"({"machine": "m", "cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
                              {"name": "Y", "list": ")" +
                               second + R"("}]})");
    return in_folder(folder.path());
  };
  // 5 cycles of 1 ms between the axes at 45°: F ΔP/2 = 166.67 µm.
  double const expected = 4000.0 / 60 * 5 / 2;
  auto const simulated = [](Surroundings const& there) {
    auto const outcome = run_axisc({"simulate", "m.json", "--program", "p.nc", "--format", "json"}, there);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return nlohmann::json::parse(outcome.out)["passes"][0]["max_contour_deviation_um"].get<double>();
  };
  auto const predicted = [](Surroundings const& there) {
    auto const outcome = run_axisc({"contour", "m.json", "--feed", "4000", "--format", "json"}, there);
    REQUIRE(outcome.status == 0);
    double line = -1;
    auto const found = nlohmann::json::parse(outcome.out);
    for (auto const& row : found["groups"][0]["table"]) {
      if (row["contour"] == "line") line = row["contour_deviation_um"].get<double>();
    }
    return line;
  };
  auto const unequal = pair("y.lis");
  CHECK(predicted(unequal) == Approx(expected).margin(0.01));
  CHECK(simulated(unequal) == Approx(expected).margin(0.01));
  CHECK_THAT(run_axisc({"contour", "m.json"}, unequal).out, Catch::Matchers::Contains("X 5, Y 0 cycles"));
  auto const equal = pair("x.lis");
  CHECK(predicted(equal) == 0);
  CHECK(simulated(equal) == 0);
}

TEST_CASE("simulate follows G135, G136 and G137") {
  TemporaryFolder const folder;
  std::string const dynamics =
      "getriebe[0].dynamik.vb_max 500000\ngetriebe[0].dynamik.a_max 10000\n"
      "getriebe[0].lslope_profil.a_stufe_1 10000\ngetriebe[0].lslope_profil.a_stufe_2 10000\nEnde\n";
  folder.write("x.lis", "vorsteuer.vorsteuerung VEL\n" + dynamics);
  folder.write("y.lis", dynamics);
  folder.write("m.json", R"({"machine": "m", "cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
                            {"name": "Y", "list": "y.lis"}]})");
  folder.write("p.nc",
               "N10 G01 X70 Y70 F4000\nN20 G135 G136 X80 Y95\nN30 X140 Y140\nN40 G137 X210 Y210\nM30\n");
  auto const outcome =
      run_axisc({"simulate", "m.json", "--program", "p.nc", "--format", "json"}, in_folder(folder.path()));
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.err.empty());
  auto const answer = nlohmann::json::parse(outcome.out);
  auto const& passes = answer["passes"];
  REQUIRE(passes.size() == 3);
  // G135 gives X, which alone is fed forward, 5 cycles of 1 ms: F ΔP/2 at 45°.
  CHECK(passes[0]["max_contour_deviation_um"] == 0);
  CHECK(passes[1]["command"] == "G135");
  CHECK(passes[1]["line"] == 2);
  CHECK(passes[1]["max_contour_deviation_um"].get<double>() == Approx(4000.0 / 60 * 5 / 2).margin(0.01));
  CHECK(passes[2]["command"] == "G137");
  CHECK(passes[2]["max_contour_deviation_um"] == 0);

  SECTION("where both axes are fed forward, nothing changes") {
    folder.write("y.lis", "vorsteuer.vorsteuerung VEL\n" + dynamics);
    auto const equal =
        run_axisc({"simulate", "m.json", "--program", "p.nc", "--format", "json"}, in_folder(folder.path()));
    REQUIRE(equal.status == 0);
    auto const found = nlohmann::json::parse(equal.out);
    REQUIRE(found["passes"].size() == 1);
    CHECK(found["passes"][0]["max_contour_deviation_um"] == 0);
  }
}

TEST_CASE("the machine file says what drives delay") {
  TemporaryFolder const folder;
  folder.write("x.lis", "getriebe[0].dynamik.vb_max 500000\nEnde\n");
  folder.write("m.json", R"({"machine": "m", "cycle_time_us": 1000, "axes": [
    {"name": "X", "list": "x.lis", "drive_delay_us": 2500}, {"name": "Y", "list": "x.lis"}]})");
  auto const there = in_folder(folder.path());
  auto const outcome =
      run_axisc({"contour", "m.json", "--budget", "--feed", "4000", "--format", "json"}, there);
  REQUIRE(outcome.status == 0);
  auto const found = nlohmann::json::parse(outcome.out)["delay_budget"];
  auto const& item = found["axes"][0]["items"][0];
  CHECK(item["item"] == "drive");
  CHECK(item["from"] == "machine_file");
  CHECK(item["basis"] == "reading");
  CHECK(item["position_cycles"] == 2.5);
  // F ΔP/2 = 4000/60 mm/s · 2.5 ms / 2 = 83.33 µm, on the line of `contour` as well.
  CHECK(found["channels"][0]["deviation_um"].get<double>() == Approx(83.33).margin(0.005));
  auto const line = run_axisc({"contour", "m.json", "--feed", "4000", "--format", "json"}, there);
  REQUIRE(line.status == 0);
  auto const predicted = nlohmann::json::parse(line.out);
  double deviation = 0;
  for (auto const& row : predicted["groups"][0]["table"]) {
    if (row["contour"] == "line") deviation = row["contour_deviation_um"].get<double>();
  }
  CHECK(deviation == Approx(83.33).margin(0.005));
}

TEST_CASE("the picture of delays stacks what lies behind the filters") {
  TemporaryFolder const folder;
  folder.write("x.lis",
               pt1 + "kenngr.antr_typ 3\nvorsteuer.vorsteuerung VEL\nvorsteuer.default_active 1\nEnde\n");
  folder.write("y.lis", pt1 + "Ende\n");
  folder.write("m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
                            {"name": "Y", "list": "y.lis", "drive_delay_us": 1500}]})");
  auto const outcome =
      run_axisc({"plot", "m.json", "--kind", "delay", "-o", "d.svg"}, in_folder(folder.path()));
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  auto const picture = folder.read("d.svg");
  // A pre-warped PT1 of 4 ms: 3.979 cycles; 5 of feedforward; its velocity goes out 3 earlier.
  CHECK_THAT(picture, Catch::Matchers::Contains("X 8.979 ms; X, v 5.979 ms; Y 5.479 ms") &&
                          Catch::Matchers::Contains("interpolator to position controller") &&
                          Catch::Matchers::Contains("P-AXIS-00165") &&
                          Catch::Matchers::Contains("in the drive"));
}

}  // namespace delay_budget_test
