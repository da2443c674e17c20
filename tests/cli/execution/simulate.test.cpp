#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

namespace simulate_test {

using namespace axisc::test;

namespace {

std::string const square = std::string(AXISC_SOURCE_DIR) + "/samples/motion/square/";

nlohmann::json simulate(Surroundings const& there, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "simulate");
  arguments.insert(arguments.end(), {"--format", "json"});
  auto const outcome = run_axisc(arguments, there);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.out);
}

Surroundings two_axes(TemporaryFolder const& folder, std::string const& more = "") {
  folder.write("a.lis",
               "filter_fir.type 1\nfilter_fir.order 40\ngetriebe[0].dynamik.vb_max 500000\n"
               "getriebe[0].dynamik.a_max 10000\ngetriebe[0].lslope_profil.a_stufe_1 10000\n"
               "getriebe[0].lslope_profil.a_stufe_2 10000\nEnde\n");
  folder.write("m.json", R"({"machine": "m", "cycle_time_us": 1000, )" + more +
                             R"("axes": [{"name": "X", "list": "a.lis"}, {"name": "Y", "list": "a.lis"}]})");
  return in_folder(folder.path());
}

}  // namespace

TEST_CASE("the manual's square, three passes in one simulation") {
  auto const found = simulate({}, {square + "machine.json", "--program", square + "square.nc"});
  auto const& passes = found["passes"];
  REQUIRE(passes.size() == 3);
  CHECK(passes[0]["max_axis_error_um"].get<double>() >= 0.95);
  CHECK(passes[0]["max_axis_error_um"].get<double>() <= 1.0);
  CHECK(passes[1]["max_axis_error_um"].get<double>() > 1.0);
  CHECK(passes[2]["max_axis_error_um"] == 0);
  CHECK(passes[2]["max_contour_deviation_um"] == 0);
  CHECK(passes[0]["time_s"].get<double>() > passes[1]["time_s"].get<double>());
  CHECK(passes[1]["time_s"].get<double>() > passes[2]["time_s"].get<double>());
  REQUIRE(found["blocks"].size() == 12);
  CHECK(found["blocks"][0]["block"] == "N040");
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(found["blocks"][i]["max_axis_error_um"].get<double>() >= 0.95);
    CHECK(found["blocks"][i]["max_axis_error_um"].get<double>() <= 1.0);
  }
}

TEST_CASE("a summary as text in both languages") {
  for (std::string const language : {"en", "de"}) {
    auto const outcome = run_axisc(
        {"simulate", square + "machine.json", "--program", square + "square.nc", "--lang", language});
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    check_golden("tests/cli/data/golden/simulate." + language, outcome.out);
  }
}

TEST_CASE("every cycle as CSV") {
  TemporaryFolder const folder;
  auto const there = two_axes(folder);
  folder.write("p.nc", "N10 G01 X1 F6000\n");
  auto const outcome =
      run_axisc({"simulate", "m.json", "--program", "p.nc", "--constant-velocity", "--format", "csv"}, there);
  CHECK(outcome.status == 0);
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line);
  CHECK(line ==
        "time_s,block,path_velocity_mm_per_min,X.setpoint_mm,X.filtered_mm,X.axis_error_um,Y.setpoint_mm,"
        "Y.filtered_mm,Y.axis_error_um,contour_deviation_um");
  std::getline(lines, line);
  CHECK(line == "0.001,N10,6000,0.1,0.1,0,0,0,0,0");  // the lists leave the filter off
  // 10 cycles of 100 µm
  CHECK(lines_of(outcome.out) == 11);

  CHECK(run_axisc({"simulate", "m.json", "--program", "p.nc", "-o", "out.csv"}, there).status == 0);
  CHECK_THAT(folder.read("out.csv"), Catch::Matchers::StartsWith("time_s,block,"));
  CHECK(run_axisc({"simulate", "m.json", "--program", "p.nc", "-o", "p.nc"}, there).status == 2);
}

TEST_CASE("every cycle of a dwell is written, wherever it is") {
  TemporaryFolder const folder;
  auto const there = two_axes(folder);
  // 100 cycles, and 10 mm at 100 mm/s and 10 m/s²: 110 cycles; the moving average has settled 40 later, and
  // once more behind the command: 100, or 40 without motion before.
  folder.write(
      "p.nc",
      "N10 G04 X0.1\nN20 G01 X10 F6000\n#FILTER ON\nN30 G04 X0.1\nN40 G01 X0\n#FILTER OFF\nN50 G04 X0.1\n");
  auto const outcome = run_axisc({"simulate", "m.json", "--program", "p.nc", "-o", "out.csv"}, there);
  CHECK(outcome.status == 0);
  std::size_t const cycles = (100 + 110) + (100 + 110 + 40) + 100;
  CHECK_THAT(outcome.out, Catch::Matchers::Contains(", " + std::to_string(cycles) + " cycles"));
  auto const rows = folder.read("out.csv");
  CHECK(lines_of(rows) == cycles + 1);
  CHECK_THAT(rows, Catch::Matchers::Contains("\n0.1,,0,0,0,0,0,0,0,0\n0.101,N20,"));
  CHECK_THAT(rows, Catch::Matchers::Contains("\n0.31,,0,10,10,0,0,0,0,0\n0.311,N40,"));
}

TEST_CASE("a program that would last too long is refused with its line") {
  TemporaryFolder const folder;
  auto const there = two_axes(folder);
  auto const refused = [&](std::string const& program, std::vector<std::string> const& more = {}) {
    folder.write("p.nc", program);
    std::vector<std::string> words{"simulate", "m.json", "--program", "p.nc"};
    words.insert(words.end(), more.begin(), more.end());
    auto const outcome = run_axisc(words, there);
    CHECK(outcome.status == 2);
    return outcome.err;
  };
  using Catch::Matchers::Contains;
  // 1 m at 1 nm/min; 0.1 mm at 1e-300 mm/min; with a tolerance.
  CHECK_THAT(refused("G01 X1 F600\nG01 F0.000001 X1000\n"),
             Contains("p.nc:2: ") && Contains("100000000 NC cycles (100000 s)") && Contains("--max-cycles"));
  CHECK_THAT(refused("F0." + std::string(299, '0') + "1 G01 X0.1\n"), Contains("p.nc:1: "));
  CHECK_THAT(refused("F0." + std::string(322, '0') + "1 G01 X0.1\n"), Contains("p.nc:1: "));
  CHECK_THAT(refused("#FILTER ON [AX_DEV=0.001]\nG01 F0.000001 X1000\nY5\n"), Contains("p.nc:2: "));
  CHECK_THAT(refused("#FILTER ON [AX_DEV=0.001]\nF0.000001 G02 I1000\nG01 Y5\n"), Contains("p.nc:2: "));
  CHECK_THAT(refused("G04 X800\nG04 X800\n", {"--max-cycles", "1000000"}), Contains("p.nc:2: "));
  // Ten million rows, 10,000 s.
  CHECK_THAT(refused("G04 X10001\n", {"-o", "out.csv"}),
             Contains("p.nc:1: ") && Contains("10000000 NC cycles"));
  CHECK_THAT(refused("G04 X10001\n", {"--format", "csv"}), Contains("10000000 NC cycles"));
  CHECK(folder.entries() == 3);
  // 10 mm at 100 mm/s and 10 m/s²: 110 cycles.
  CHECK_THAT(refused("G01 X10 F6000\n", {"--max-cycles", "109"}),
             Contains("p.nc:1: ") && Contains("109 NC cycles"));
  CHECK(run_axisc({"simulate", "m.json", "--program", "p.nc", "--max-cycles", "110"}, there).status == 0);
  CHECK_THAT(refused("G01 X10 F6000\n", {"--max-cycles", "0"}), Contains("--max-cycles"));
}

TEST_CASE("of a long program the first ten thousand blocks are shown") {
  TemporaryFolder const folder;
  auto const there = two_axes(folder);
  folder.write("p.nc", "G01 F60000 G91\n$FOR P1 = 1, 10010, 1\nX1\n$ENDFOR\nM30\n");
  auto const found = simulate(there, {"m.json", "--program", "p.nc"});
  CHECK(found["blocks"].size() == 10'000);
  CHECK(found["block_count"] == 10'010);
  CHECK(found["pass_count"] == 1);
  CHECK_THAT(run_axisc({"simulate", "m.json", "--program", "p.nc"}, there).out,
             Catch::Matchers::Contains("\n  and 10 more\n"));
}

TEST_CASE("passes say which tolerance they keep") {
  TemporaryFolder const folder;
  auto const there = two_axes(folder);
  folder.write("p.nc", "#FILTER ON [AX_DEV=0.01]\nG01 X1 F1000\nY1\n#FILTER ON\nX0\n");
  auto const found = simulate(there, {"m.json", "--program", "p.nc"});
  CHECK(found["passes"][0]["tolerance_um"] == 10);
  CHECK(found["passes"][0]["tolerance_kept"] == true);
  CHECK(found["passes"][1]["tolerance_um"].is_null());
  CHECK(found["passes"][1]["tolerance_kept"].is_null());
}

TEST_CASE("predicted and simulated corners agree at constant path velocity") {
  TemporaryFolder const folder;
  auto const there = two_axes(folder);
  folder.write("p.nc", "#FILTER ON\nG01 X10 F1000\nY10\nX0\nY0\n");
  auto const found = simulate(there, {"m.json", "--program", "p.nc", "--constant-velocity"});
  CHECK(found["passes"][0]["max_axis_error_um"].get<double>() == Approx(85.366).epsilon(0.005));
  CHECK(found["passes"][0]["max_contour_deviation_um"].get<double>() == Approx(120.726).epsilon(0.005));
}

TEST_CASE("programs from standard input, in inches, with a command of their own") {
  TemporaryFolder const folder;
  auto there = two_axes(folder, R"("inch": true, )");
  there.input = "#FILTER ON [ORDER=100]\nG01 X1 F100\nY1\n";
  auto const found = simulate(there, {"m.json", "--program", "-"});
  CHECK(found["passes"][0]["blocks"] == 2);
  // One inch at 100 inch/min takes 0.6 s and the ramps.
  CHECK(found["blocks"][0]["time_s"].get<double>() == Approx(0.6).margin(0.05));
}

TEST_CASE("what the simulation does not follow is named with its place") {
  TemporaryFolder const folder;
  auto const there = two_axes(folder);
  folder.write("warned.nc", "N10 G01 X1 F1000 S500\nN20 Y1 M08\n");
  auto const warned = run_axisc({"simulate", "m.json", "--program", "warned.nc", "--color", "never"}, there);
  CHECK(warned.status == 0);
  check_golden("tests/cli/data/golden/simulate.warned", warned.err);
  folder.write("refused.nc", "N10 G01 X1 F1000\nN20 G02 X2 Y2 I1 J0\n#FILTER ON [ORDER=300]\nN30 X=P1\n");
  auto const refused =
      run_axisc({"simulate", "m.json", "--program", "refused.nc", "--color", "never"}, there);
  CHECK(refused.status == 1);
  CHECK(refused.out.empty());
  check_golden("tests/cli/data/golden/simulate.refused", refused.err);
}

TEST_CASE("a part program with subprograms and loops, and one that has everything") {
  auto const there = in_folder(std::string(AXISC_SOURCE_DIR) + "/samples/mill");
  auto const part = simulate(there, {"machine.json", "--program", "part.nc"});
  CHECK(part["block_count"] == 17);
  auto const everything = simulate(there, {"machine.json", "--program", "plate.nc"});
  // 1 rapid, 3 depths of 6 blocks, 4 holes of 3 blocks (the first is deep enough already), a helix of 2
  // blocks, 1 rapid.
  CHECK(everything["block_count"] == 1 + 3 * 6 + 4 * 3 - 1 + 2 + 1);
}

TEST_CASE("blocks last as long as their lengths") {
  auto const there = in_folder(std::string(AXISC_SOURCE_DIR) + "/samples/mill");
  auto const found = simulate(there, {"machine.json", "--program", "lengths.nc", "--constant-velocity"});
  constexpr double pi = 3.14159265358979;
  // The sample says them, in mm; each block is passed at 10 mm/s.
  std::vector<std::pair<std::string, double>> const lengths = {
      {"N110", 2 * pi * 5}, {"N120", pi * 10}, {"N130", pi / 2 * 6}, {"N140", std::hypot(2 * pi * 3, 4)},
      {"N150", 5},          {"N160", 10},      {"N170", 17.8},       {"N190", 10},
      {"N10", 1},           {"N10", 1},        {"N10", 1},           {"N260", 2}};
  auto const& blocks = found["blocks"];
  REQUIRE(blocks.size() == lengths.size() + 1);
  CHECK(blocks.back()["block"] == "N280");
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    INFO(lengths[i].first);
    CHECK(blocks[i]["block"] == lengths[i].first);
    CHECK(blocks[i]["time_s"].get<double>() == Approx(lengths[i].second / 10).margin(1e-4));
  }
}

TEST_CASE("what simulate refuses") {
  TemporaryFolder const folder;
  auto const there = two_axes(folder);
  folder.write("p.nc", "G01 X1 F1000\n");
  CHECK(run_axisc({"simulate", "m.json"}, there).status == 2);
  CHECK(run_axisc({"simulate", "m.json", "--plant", "p.json"}, there).status == 2);
  CHECK(run_axisc({"simulate", "m.json", "--program", "missing.nc"}, there).status == 2);
  CHECK(run_axisc({"simulate", "m.json", "--program", "."}, there).status == 2);
  CHECK(run_axisc({"simulate", "m.json", "--program", "p.nc", "--group", "none"}, there).status == 2);
}

TEST_CASE("progress is shown where it is wanted") {
  TemporaryFolder const folder;
  auto const there = two_axes(folder);
  folder.write("p.nc", "G01 X1 F1000\n");
  auto const outcome = run_axisc({"simulate", "m.json", "--program", "p.nc", "--progress"}, there);
  CHECK_THAT(outcome.err, Catch::Matchers::Contains("% of the program"));
  CHECK(run_axisc({"simulate", "m.json", "--program", "p.nc"}, there).err.empty());
}

TEST_CASE("a program of one block has one block") {
  TemporaryFolder const folder;
  folder.write("part.nc", "G01 X10 F1000\n");
  auto const said = [&](std::string const& language) {
    return run_axisc(
               {"simulate", AXISC_SOURCE_DIR "/samples/mill", "--program", "part.nc", "--lang", language},
               in_folder(folder.path()))
        .out;
  };
  CHECK_THAT(said("en"), Catch::Matchers::StartsWith("1 block, "));
  CHECK_THAT(said("de"), Catch::Matchers::StartsWith("1 Satz, "));
}

}  // namespace simulate_test
