// The picture of a motion from rest to rest, against figures by hand.
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

std::string const sample = AXISC_SOURCE_DIR "/samples/motion/dynamics/machine.json";

/// Rows of a printed table, its cells joined with one blank.
std::vector<std::string> rows_of(std::string const& table) {
  std::vector<std::string> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string row;
    for (std::string word; words >> word;) row += (row.empty() ? "" : " ") + word;
    rows.push_back(row);
  }
  return rows;
}

std::vector<std::string> table(std::vector<std::string> words, std::string const& folder) {
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
  auto const rows = table({sample, "--axis", "X"}, ".");
  REQUIRE(rows.size() == 3);
  CHECK(rows[1] == "X F6000 2000 50 40 100 of 500 0.04 1.1");
  CHECK(rows[2] == "X G00 4000 20 200 400 of 400 - 0.37");
  // 2 mm, too short for 100 mm/s: four ramps of q tr, q³ = L/(2 a tr²) = 0.2, the peak is q² a tr.
  auto const brief = table({sample, "--axis", "X", "--distance", "2"}, ".");
  CHECK(brief[1] == "X F6000 2000 50 40 34.2 of 500 0.04 0.117");
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
  auto const rows = table({"m.json"}, folder.path());
  CHECK(rows[1] == "X F6000 2000, above 50 mm/s 1000 / 4000 - ∞ 100 of 500 2 1.044");
}

TEST_CASE("dynamics: each of the four ramps, in HSC the longest of them") {
  TemporaryFolder const folder;
  std::string const ramps =
      limits +
      ",slope_profil.a_beschl 2000,slope_profil.a_brems 1000,slope_profil.tr_beschl_zu 50000,"
      "slope_profil.tr_beschl_ab 40000,slope_profil.tr_brems_zu 20000,slope_profil.tr_brems_ab 100000";
  write_machine(folder, ramps, "prog_start.slope.profile 1");
  // Of all four, the longest counts through a corner: 1000 1e-6/0.1 mm/s.
  auto const trapez = table({"m.json"}, folder.path());
  CHECK_THAT(trapez[1], Catch::Matchers::StartsWith(
                            "X F6000 2000 / 1000 50, 40 / 20, 100 40, 50 / 50, 10 100 of 500 0.01"));
  write_machine(folder, ramps, "prog_start.slope.profile 3");
  // Up 2 tr q with q = √(v/(a tr)) = √0.5, as a is not reached: 0.141421 s; down 0.1 + 0.1 s. 1 + half of
  // both.
  auto const hsc = table({"m.json"}, folder.path());
  CHECK(hsc[1] == "X F6000 2000 / 1000 100 20 / 10 100 of 500 0.01 1.171");
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
