// What a change of accelerations, ramp times and the channel list does to a motion, against figures by hand.
#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

#include <string>

#include <nlohmann/json.hpp>

namespace diff_dynamics_test {

using namespace axisc::test;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

/// A machine of one axis with 2000 mm/s² by all slopes and ramps of 50 ms.
void write_machine(TemporaryFolder const& folder, std::string const& name, std::string const& more,
                   std::string const& channel) {
  std::string const gear = "getriebe[0].";
  folder.write(name + "/x.lis", "kopf.achs_nr 1\nkenngr.achs_typ 1\n" + gear + "dynamik.vb_max 500000\n" +
                                    gear + "dynamik.a_max 4000\n" + gear + "lslope_profil.a_stufe_1 2000\n" +
                                    gear + "lslope_profil.a_stufe_2 2000\n" + gear +
                                    "slope_profil.a_beschl 2000\n" + gear + "slope_profil.a_brems 2000\n" +
                                    more + "Ende\n");
  folder.write(name + "/sda.lis", channel + "\nEnde\n");
  folder.write(name + "/m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}],
    "groups": [{"name": "c", "axes": ["X"], "channel_list": "sda.lis"}]})");
}

std::string const trapez = "prog_start.slope.profile 1";

struct Compared {
  std::string text;
  json data;
};

Compared compared(TemporaryFolder const& folder) {
  auto const there = in_folder(folder.path());
  auto const text = run_axisc({"diff", "old/m.json", "new/m.json"}, there);
  auto const data = run_axisc({"diff", "old/m.json", "new/m.json", "--format", "json"}, there);
  INFO(text.err);
  CHECK(text.status <= 1);
  return {.text = text.out, .data = json::parse(data.out)};
}

}  // namespace

TEST_CASE("diff: other accelerations and ramp times take another time") {
  TemporaryFolder const folder;
  write_machine(folder, "old", "", trapez);
  write_machine(folder, "new",
                "getriebe[0].slope_profil.a_beschl 1000\ngetriebe[0].slope_profil.a_brems 1000\n"
                "getriebe[0].slope_profil.a_grenz 2000\n",
                trapez);
  // 100/100 + v/a + tr: 1.1 and 1.15 s. Corner a T²/tr: 0.04 and 0.02 mm/s.
  // G00: v = 166.666 mm/s in 10 ms: 100/v + v/a + tr = 0.6 + 0.166666 + 0.01, then 0.6 + 0.083333 + 0.01 s.
  auto const found = compared(folder);
  CHECK_THAT(found.text,
             Contains("100 mm at F6000, slope TRAPEZ") && Contains("1.1 s") && Contains("1.15 s") &&
                 Contains("100 mm in G00, slope TRAPEZ") && Contains("0.7767 s") && Contains("0.6933 s") &&
                 Contains("velocity through a 90° corner") && Contains("0.04 mm/s") && Contains("0.02 mm/s"));
  auto const& motion = found.data["axes"][0]["motion"];
  CHECK(motion["distance_mm"] == 100);
  CHECK(motion["feed_mm_per_min"] == 6000);
  CHECK(motion["before"]["at_feed_s"].get<double>() == Approx(1.1));
  CHECK(motion["after"]["at_feed_s"].get<double>() == Approx(1.15));
  CHECK(motion["after"]["corner_velocity_mm_s"].get<double>() == Approx(0.02));
  CHECK(motion["before"]["slope"] == "TRAPEZ");
}

TEST_CASE("diff: another channel list alone is a difference of channel and axes") {
  TemporaryFolder const folder;
  write_machine(folder, "old", "", trapez);
  write_machine(folder, "new", "", "prog_start.slope.profile 0");
  // STEP: 100/100 + 100/2000 s.
  auto const found = compared(folder);
  CHECK_THAT(found.text, Contains("prog_start.slope.profile") && Contains("TRAPEZ") && Contains("STEP") &&
                             Contains("100 mm at F6000") && Contains("1.05 s"));
  CHECK(found.data["equal"] == false);
  CHECK(found.data["channels"][0]["dynamics"] == json::array({{{"parameter", "P-CHAN-00071"},
                                                               {"name", "prog_start.slope.profile"},
                                                               {"before", "TRAPEZ"},
                                                               {"after", "STEP"}}}));
  CHECK(found.data["axes"][0]["motion"]["after"]["at_feed_s"].get<double>() == Approx(1.05));
  CHECK(found.data["axes"][0]["parameters"].empty());
}

TEST_CASE("diff: what changes no motion of a single axis is a difference of the channel alone") {
  TemporaryFolder const folder;
  write_machine(folder, "old", "", trapez);
  write_machine(folder, "new", "", trapez + "\nconfiguration.interpolator.function FCT_LOOK_AHEAD_LOW");
  auto const found = compared(folder);
  CHECK(found.data["channels"][0]["dynamics"][0]["parameter"] == "P-CHAN-00653");
  CHECK(found.data["channels"][0]["dynamics"][0]["after"] == "30");
  CHECK(found.data["axes"].empty());
  write_machine(folder, "new", "", trapez + "\n( same\ncorr_v_trans_jerk 0");
  CHECK(compared(folder).data["equal"] == true);
}

TEST_CASE("diff: what no plan computes is named beside the figures, and an image tells no channel list") {
  TemporaryFolder const folder;
  write_machine(folder, "old", "getriebe[0].beschl_kennlinie.typ 1\n", trapez);
  write_machine(folder, "new", "", "prog_start.slope.profile 0");
  auto const found = compared(folder);
  CHECK_THAT(found.text, Contains("not computed") && Contains("P-AXIS-00202"));
  CHECK(found.data["axes"][0]["motion"]["before"]["not_computed"] == json::array({"P-AXIS-00202"}));

  auto const there = in_folder(folder.path());
  REQUIRE(run_axisc({"compile", "old/m.json", "-o", "old.axim", "--quiet"}, there).status == 0);
  auto const image =
      json::parse(run_axisc({"diff", "old.axim", "new/m.json", "--format", "json"}, there).out);
  for (auto const& axis : image["axes"]) CHECK_FALSE(axis.contains("motion"));
}

TEST_CASE("diff: lists without a channel list are compared with the control's default") {
  TemporaryFolder const folder;
  write_machine(folder, "old", "", trapez);
  write_machine(folder, "new", "getriebe[0].lslope_profil.a_stufe_1 1000\n", trapez);
  auto const outcome = run_axisc({"diff", "old/x.lis", "new/x.lis", "--cycle-time", "1ms", "--lang", "de"},
                                 in_folder(folder.path()));
  INFO(outcome.out);
  CHECK_THAT(outcome.out, Contains("100 mm mit F6000, Slope STEP (Standardwert)") && Contains("1,05 s") &&
                              Contains("1,1 s"));
}

}  // namespace diff_dynamics_test
