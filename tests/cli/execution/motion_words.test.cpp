// The programs of samples/motion/dynamics: what each word that says how a path is driven does, against
// figures by hand. X and Y have 2 m/s² and ramps of 50 ms: from rest to 100 mm/s in 0.1 s and 5 mm.
#include "schema/motion_words.hpp"

#include "constructs.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace motion_words_test {

using namespace axisc::test;

namespace {

nlohmann::json simulated(std::string const& program) {
  auto const outcome =
      run_axisc({"simulate", "machine.json", "--program", program, "--color", "never", "--format", "json"},
                in_folder(std::string(AXISC_SOURCE_DIR) + "/samples/motion/dynamics"));
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.out);
}

/// A ramp by v with acceleration a, built up and taken back in tr each:  v/a + tr, or where a is not reached
/// 2 tr q with q = √(v / (a tr)).
double ramp(double v, double a = 2000, double tr = 0.05) {
  return v >= a * tr ? v / a + tr : 2 * tr * std::sqrt(v / (a * tr));
}

/// From rest to rest: both ramps together cover what one of their times covers at v.
double stop_to_stop(double L, double v = 100, double a = 2000, double tr = 0.05) {
  return L / v + ramp(v, a, tr);
}

}  // namespace

TEST_CASE("motion words: weights of accelerations, ramp times and velocities") {
  double const plain = stop_to_stop(100);
  double const half = stop_to_stop(100, 100, 1000);
  double const long_ramps = stop_to_stop(100, 100, 2000, 0.1);
  double const slow = stop_to_stop(100, 50);
  double const rapid = stop_to_stop(100, 400, 4000, 0.02);
  // On the circle v³/ρ² = a/tr, and along it what is left of a beside v²/ρ.
  double const v = std::cbrt(2000 * 400 / 0.3);
  double const along = std::sqrt(2000.0 * 2000.0 - std::pow(v * v / 20, 2));
  check_times(simulated("weights.nc"), {{"N20", plain},
                                        {"N40", half},
                                        {"N60", stop_to_stop(100, 100, 3000)},
                                        {"N80", long_ramps},
                                        {"N100", half},
                                        {"N110", plain},
                                        {"N130", plain},
                                        {"N140", long_ramps},
                                        {"N160", stop_to_stop(100, 100, 2000, 0.01)},
                                        {"N180", slow},
                                        {"N200", plain},
                                        {"N220", plain},
                                        {"N230", slow},
                                        {"N250", rapid},
                                        {"N270", stop_to_stop(100, 400, 2000, 0.02)},
                                        {"N290", stop_to_stop(100, 400, 4000, 0.04)},
                                        {"N310", stop_to_stop(100, 400, 2000, 0.02)},
                                        {"N320", rapid},
                                        {"N340", stop_to_stop(100, 100, 4000, 0.02)},
                                        {"N360", stop_to_stop(40 * std::numbers::pi, v, along)}});
}

TEST_CASE("motion words: exact stops in one block and from here on") {
  double const way = 10 / 100.0;
  double const more = 0.05;  // of each ramp from or to rest
  check_times(simulated("stops.nc"), {{"N20", way + 2 * more},
                                      {"N30", way + more},
                                      {"N40", way},
                                      {"N60", way + more},
                                      {"N70", way + 2 * more},
                                      {"N90", way + more},
                                      {"N100", way + more}});
}

TEST_CASE("motion words: slopes") {
  double const step = 100 / 100.0 + 100 / 2000.0;
  check_times(simulated("slopes.nc"), {{"N20", stop_to_stop(100)},
                                       {"N40", step},
                                       {"N50", 2 * std::sqrt(0.5 / 2000)},
                                       {"N70", stop_to_stop(100)},
                                       {"N90", 4 * std::cbrt(0.5 / (2 * 2000 / 0.05))},
                                       {"N110", stop_to_stop(100)},
                                       {"N130", step},
                                       {"N150", stop_to_stop(100)}});
}

TEST_CASE("motion words: limits of the path and functions of the look-ahead") {
  check_times(simulated("limits.nc"), {{"N30", stop_to_stop(100, 50)},
                                       {"N50", stop_to_stop(100)},
                                       {"N80", 1 + 100 / 1000.0},
                                       {"N100", (100 - 5 - 2.5) / 100 + 0.1 + 0.05},
                                       {"N140", 50 / 100.0 + 0.05},
                                       {"N150", 50 / 100.0 + 0.05}});
}

TEST_CASE("motion words: braking for a lower feed behind a block, or by its end") {
  double const change = 50 / 2000.0;  // from 50 to 100 mm/s and back, 1.875 mm
  double const up_and_down = (20 - 2 * 1.875) / 100 + 2 * change;
  check_times(simulated("braking.nc"), {{"N20", (20 - 2.5) / 100 + 0.05},
                                        {"N30", (20 - 1.875) / 50 + change},
                                        {"N40", up_and_down},
                                        {"N50", 20 / 50.0},
                                        {"N60", up_and_down},
                                        {"N70", (20 - 0.625) / 50 + change}});
}

TEST_CASE("motion words: those that change nothing") {
  std::vector<TimedBlock> expected;
  for (std::string const label :
       {"N20", "N30", "N40", "N50", "N60", "N80", "N100", "N150", "N170", "N185", "N190"}) {
    expected.push_back({label, stop_to_stop(100)});
  }
  check_times(simulated("accepted.nc"), expected);
}

TEST_CASE("motion words: the least velocity through corners, in a program") {
  auto const found = simulated("corners.nc");
  // a T²/tr, and 60 mm/min; of both blocks of a corner the lower one counts, which is a reading.
  std::vector<double> const mm_per_s = {0.04, 0.04, 0.04, 1, 0.04, 0.04, 0};
  REQUIRE(found["blocks"].size() == mm_per_s.size());
  for (std::size_t i = 0; i < mm_per_s.size(); ++i) {
    INFO(found["blocks"][i]["block"]);
    CHECK(found["blocks"][i]["velocity_out_mm_s"].get<double>() == Approx(mm_per_s[i]).margin(1e-9));
  }
}

namespace {

/// The words of a program, without comments, each behind a blank.
std::string words_of(std::filesystem::path const& program) {
  std::string words = " ";
  int depth = 0;
  for (char const letter : read_source_file(program)) {
    if (letter == '(') ++depth;
    if (depth == 0) words += letter == '\n' || letter == '=' || letter == '[' ? ' ' : letter;
    if (letter == ')') --depth;
  }
  return words + " ";
}

}  // namespace

TEST_CASE("motion words: each is in a sample that follows it, or that is refused at it") {
  std::string followed;
  for (auto const& entry : std::filesystem::directory_iterator(AXISC_SOURCE_DIR "/samples/motion/dynamics")) {
    if (entry.path().extension() != ".nc") continue;
    std::string const name = entry.path().filename().string();
    simulated(name);
    followed += words_of("samples/motion/dynamics/" + name);
  }
  std::string const refused = words_of("samples/motion/constructs/foreign.nc");
  for (auto const& word : axisc::schema::motion_words()) {
    INFO(word.word);
    bool const is_refused = word.use == axisc::schema::WordUse::refused;
    CHECK_THAT(is_refused ? refused : followed,
               Catch::Matchers::Contains(" " + std::string(word.word) + " "));
  }
}

TEST_CASE("motion words: the least velocity through a corner") {
  TemporaryFolder const folder;
  auto const velocity = [&](std::string const& command) {
    folder.write("p.nc", "G17 G71 G91 G94 F6000 " + command + "\nN10 G01 X50\nN20 Y50\nM30\n");
    auto const outcome =
        run_axisc({"simulate", std::string(AXISC_SOURCE_DIR) + "/samples/motion/dynamics/machine.json",
                   "--program", folder / "p.nc", "--format", "json"});
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    auto const found = nlohmann::json::parse(outcome.out);
    return found["blocks"][0]["velocity_out_mm_s"].get<double>();
  };
  // v = a T²/tr: 2000 mm/s², 1 ms, 50 ms.
  CHECK(velocity("") == Approx(0.04));
  CHECK(velocity("#TRANSVELMIN ON [60]") == Approx(1));
  CHECK(velocity("#TRANSVELMIN ON [60]\n#TRANSVELMIN OFF") == Approx(0.04));
}

TEST_CASE("motion words: with sharp corners the summary carries the bound") {
  TemporaryFolder const folder;
  folder.write("p.nc",
               "G17 G71 G91 G94 F6000\n#CONTOUR MODE [DEV PATH_DEV=0.2]\nN10 G01 G61 X50\nN20 Y50\nM30\n");
  std::vector<std::string> const words = {
      "simulate", std::string(AXISC_SOURCE_DIR) + "/samples/motion/dynamics/machine.json", "--program",
      folder / "p.nc"};
  auto const refused = run_axisc(words);
  CHECK(refused.status == 1);
  CHECK_THAT(refused.err,
             Catch::Matchers::Contains("`G61` cannot be simulated: the control rounds this corner"));
  auto sharp = words;
  sharp.emplace_back("--sharp-corners");
  auto const followed = run_axisc(sharp);
  CHECK(followed.status == 0);
  CHECK_THAT(followed.out, Catch::Matchers::Contains("rounds them, by 0.2 mm at most"));
  sharp.insert(sharp.end(), {"--format", "json"});
  CHECK(nlohmann::json::parse(run_axisc(sharp).out)["corners_rounded_by_up_to_mm"] == 0.2);
}

TEST_CASE(
    "what lists set and no plan computes is named once at its place, and the defaults of a missing channel "
    "list") {
  TemporaryFolder const folder;
  folder.write("x.lis", "getriebe[0].slope_profil.j_accel 20 ( P-AXIS-00561\nEnde\n");
  folder.write("sda.lis", "prog_start.slope.profile 1\ntrans_limit_with_curvature 1\nEnde\n");
  folder.write("machine.json",
               R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}],
                   "groups": [{"axes": ["X"], "channel_list": "sda.lis"}]})");
  folder.write("p.nc", "N10 G01 G91 X100 F6000\nM30\n");
  auto const simulate = [&](std::string const& machine) {
    return run_axisc({"simulate", machine, "--program", "p.nc", "--color", "never"},
                     in_folder(folder.path()));
  };
  auto const listed = simulate("machine.json");
  CHECK(listed.status == 0);
  CHECK_THAT(listed.err,
             Catch::Matchers::Contains("warning[AX9007]") && Catch::Matchers::Contains("x.lis:1:1") &&
                 Catch::Matchers::Contains("P-AXIS-00561") && Catch::Matchers::Contains("sda.lis:2:1") &&
                 Catch::Matchers::Contains("P-CHAN-00245"));
  CHECK_THAT(listed.out, Catch::Matchers::Contains(
                             "slope TRAPEZ at the beginning, look-ahead of 120 blocks, as the channel list"));
  folder.write("alone.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}]})");
  CHECK_THAT(simulate("alone.json").out, Catch::Matchers::Contains("as no channel list is named"));
}

}  // namespace motion_words_test
