// The picture of a motion from rest to rest, against figures by hand.
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace dynamics_plot_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

using Rows = std::vector<std::string>;

std::string const sample = AXISC_SOURCE_DIR "/samples/motion/dynamics/machine.json";

/// Rows of a printed table, its cells joined with one blank.
Rows rows_of(std::string const& table) {
  Rows rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string row;
    for (std::string word; words >> word;) row += (row.empty() ? "" : " ") + word;
    rows.push_back(row);
  }
  return rows;
}

Rows table(std::vector<std::string> words, std::string const& folder) {
  words.insert(words.begin(), "plot");
  words.insert(words.end(), {"--kind", "dynamics", "--table"});
  auto const outcome = run_axisc(words, in_folder(folder));
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return rows_of(outcome.out);
}

/// A machine of an axis with these values of gear 0, and of a channel list.
void write_machine(TemporaryFolder const& folder, std::string const& values, std::string const& channel,
                   std::string const& type = "1") {
  std::string list = "kopf.achs_nr 1\nkenngr.achs_typ " + type + "\n";
  std::istringstream lines(values);
  for (std::string line; std::getline(lines, line, ',');) list += "getriebe[0]." + line + "\n";
  folder.write("x.lis", list);
  folder.write("sda.lis", channel + "\nEnde\n");
  folder.write("m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}],
    "groups": [{"axes": ["X"], "channel_list": "sda.lis"}]})");
}

std::string const limits = "dynamik.vb_max 500000,vb_eilgang 400000,dynamik.a_max 4000";

}  // namespace

TEST_CASE("dynamics: TRAPEZ at feed and in G00, by hand") {
  // 2000 mm/s², 50 ms: 40 m/s³; 100 mm: 1 + 100/2000 + 0.05 s; corner a T²/tr = 2000 1e-6/0.05 mm/s.
  // G00: 4000 mm/s², 20 ms: 200 m/s³; 100/400 + 400/4000 + 0.02 s.
  CHECK(table({sample, "--axis", "X"}, ".") ==
        Rows{"axis quantity F6000 G00", "X slope TRAPEZ TRAPEZ", "X a [mm/s²] 2000 4000", "X tr [ms] 50 20",
             "X a/tr [m/s³] 40 200", "X velocity limit [mm/s] 500 400", "X velocity reached [mm/s] 100 400",
             "X through a corner of 90° [mm/s] 0.04 -", "X time [s] 1.1 0.37"});
  // 2 mm, too short for 100 mm/s: four ramps of q tr, q³ = L/(2 a tr²) = 0.2, the peak is q² a tr.
  auto const brief = table({sample, "--axis", "X", "--distance", "2", "--feed", "6000"}, ".");
  CHECK(brief.at(6).starts_with("X velocity reached [mm/s] 34.2 "));
  CHECK(brief.at(8).starts_with("X time [s] 0.117 "));
}

TEST_CASE("dynamics: STEP with stages, and braking unlike accelerating") {
  TemporaryFolder const folder;
  write_machine(folder,
                limits +
                    ",lslope_profil.a_stufe_1 2000,lslope_profil.a_stufe_2 1000,"
                    "lslope_profil.vb_stufe_1_2 50000,lslope_profil.d_stufe_1 4000,"
                    "lslope_profil.d_stufe_2 4000",
                "prog_start.slope.profile 0");
  // Up 50/2000 + 50/1000 = 0.075 s for 0.625 + 3.75 mm, down 0.025 s for 1.25 mm, 94.375 mm at 100 mm/s.
  // The corner takes the stage below the changeover: a T = 2 mm/s.
  // G00: 1000 mm/s²; 400 mm/s would need 160 mm: √(100 1000) mm/s, 2 √(100/1000) s.
  CHECK(table({"m.json"}, folder.path()) ==
        Rows{"axis quantity F6000 G00", "X slope STEP STEP", "X a, accelerating [mm/s²] 2000 1000",
             "X a, braking [mm/s²] 4000 1000", "X a above the changeover, accelerating [mm/s²] 1000 -",
             "X changeover [mm/s] 50 -", "X velocity limit [mm/s] 500 400",
             "X velocity reached [mm/s] 100 316.2", "X through a corner of 90° [mm/s] 2 -",
             "X time [s] 1.044 0.6325"});
}

TEST_CASE("dynamics: each of the four ramps, in HSC the longest of them") {
  TemporaryFolder const folder;
  std::string const ramps =
      limits +
      ",slope_profil.a_beschl 2000,slope_profil.a_brems 1000,slope_profil.tr_beschl_zu 50000,"
      "slope_profil.tr_beschl_ab 40000,slope_profil.tr_brems_zu 20000,slope_profil.tr_brems_ab 100000";
  write_machine(folder, ramps, "prog_start.slope.profile 1");
  auto const trapez = table({"m.json"}, folder.path());
  // G00: 1000 mm/s², 10 ms; 100 m/s³.
  Rows const expected{"X a, accelerating [mm/s²] 2000 1000",
                      "X a, braking [mm/s²] 1000 1000",
                      "X tr, building up acceleration [ms] 50 10",
                      "X tr, taking back acceleration [ms] 40 10",
                      "X tr, building up deceleration [ms] 20 10",
                      "X tr, taking back deceleration [ms] 100 10",
                      "X a/tr, building up acceleration [m/s³] 40 100",
                      "X a/tr, taking back acceleration [m/s³] 50 100",
                      "X a/tr, building up deceleration [m/s³] 50 100",
                      "X a/tr, taking back deceleration [m/s³] 10 100"};
  for (auto const& row : expected) {
    INFO(row);
    CHECK(std::count(trapez.begin(), trapez.end(), row) == 1);
  }
  // Of all four, the longest counts through a corner: 1000 1e-6/0.1 mm/s.
  CHECK(std::count(trapez.begin(), trapez.end(), "X through a corner of 90° [mm/s] 0.01 -") == 1);
  write_machine(folder, ramps, "prog_start.slope.profile 3");
  // Up 2 tr q with q = √(v/(a tr)) = √0.5, as a is not reached: 0.141421 s; down 0.1 + 0.1 s. 1 + half of
  // both.
  auto const hsc = table({"m.json"}, folder.path());
  CHECK(std::count(hsc.begin(), hsc.end(), "X tr [ms] 100 10") == 1);
  CHECK_THAT(hsc.back(), Catch::Matchers::StartsWith("X time [s] 1.171 "));
}

TEST_CASE("dynamics: a channel without a list says so, and what no channel moves is not drawn") {
  TemporaryFolder const folder;
  write_machine(folder, limits, "prog_start.slope.profile 2", "2");
  folder.write("m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "C", "list": "x.lis"},
    {"name": "S", "list": "s.lis"}], "groups": [{"axes": ["C"]}]})");
  folder.write("s.lis", "kopf.achs_nr 2\nkenngr.achs_typ 4\n");
  auto const drawn = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"plot", "m.json", "--kind", "dynamics", "-o", "-"});
    auto const outcome = run_axisc(words, in_folder(folder.path()));
    CHECK(outcome.status == 0);
    return outcome.out;
  };
  // 1000 °/s² by default: 100° in 1.1 s.
  CHECK_THAT(drawn({}),
             Contains("C: 100° at F6000 from rest to rest, slope STEP (default: no channel list)") &&
                 Contains("C: 1.1 s, 100 °/s"));
  CHECK_THAT(drawn({"--axis", "S", "--lang", "de"}), Contains("Kein Kanal bewegt S auf einer Bahn."));
}

TEST_CASE("dynamics: approved pictures") {
  TemporaryFolder const folder;
  write_machine(folder, limits + ",slope_profil.a_beschl 2000,slope_profil.a_brems 2000",
                "prog_start.slope.profile 2");
  for (std::string const language : {"en", "de"}) {
    for (auto const& [name, words] : std::map<std::string, std::vector<std::string>>{
             {"dynamics", {sample}},
             {"dynamics.X", {sample, "--axis", "X"}},
             {"dynamics.change", {sample, "--axis", "X", "--before", "m.json"}}}) {
      std::vector<std::string> line{"plot", "--kind", "dynamics", "-o", "-", "--lang", language};
      line.insert(line.begin() + 1, words.begin(), words.end());
      auto const outcome = run_axisc(line, in_folder(folder.path()));
      INFO(outcome.err);
      CHECK(outcome.status == 0);
      check_golden("tests/cli/data/golden/plots/" + name + "." + language + ".svg", outcome.out);
    }
  }
}

TEST_CASE("dynamics: bad values, and an image, are refused") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  REQUIRE(run_axisc({"compile", sample, "-o", "m.axim", "--quiet"}, there).status == 0);
  auto const refused = [&](std::vector<std::string> words, std::string const& reason) {
    words.insert(words.begin(), "plot");
    words.insert(words.end(), {"-o", "p.svg"});
    auto const outcome = run_axisc(words, there);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains(reason));
  };
  refused({"m.axim", "--kind", "dynamics"}, "--kind dynamics needs the machine: m.axim is an image");
  refused({sample, "--kind", "dynamics", "--before", "m.axim"}, "needs the machine: m.axim is an image");
  refused({sample, "--kind", "dynamics", "--distance", "0"}, "--distance");
  refused({sample, "--kind", "dynamics", "--feed", "1000,2000"}, "--feed");
  refused({sample, "--kind", "step", "--distance", "10"}, "--distance");
  refused({sample, "--kind", "dynamics", "--at", "0:#FILTER ON"}, "--at");
}

}  // namespace dynamics_plot_test
