// AX8001 with channel lists that say which accelerations and ramp times a weight is of.
#include "support/catch.hpp"
#include "support/checked.hpp"

#include <map>
#include <string>

namespace weighted_values_test {

namespace {

using namespace axisc;
using tests::Checked;

/// What AX8001 says of each weight of a program: the parameter that is limited, in the order of the program.
tests::Lines limited(std::string const& channel, std::string const& program) {
  std::string const gear = "getriebe[0].";
  Checked const checked(
      {{"x.lis", "kopf.achs_nr 1\n" + gear + "dynamik.a_max 4000\n" + gear +
                     "lslope_profil.a_stufe_1 2000\n" + gear + "lslope_profil.a_stufe_2 2000\n" + gear +
                     "lslope_profil.d_stufe_1 4000\n" + gear + "slope_profil.a_beschl 1000\n" + gear +
                     "slope_profil.a_brems 4000\n" + gear + "slope_profil.tr_beschl_ab 20000\n"},
       {"sda.lis", channel},
       {"p.nc", program},
       {"m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}],
         "groups": [{"axes": ["X"], "channel_list": "sda.lis", "programs": ["p.nc"]}]})"}},
      "m.json");
  tests::Lines found;
  for (Finding const& finding : checked.result.findings) {
    if (finding.code != Code{8001}) continue;
    REQUIRE(finding.control);
    CHECK(finding.control->message.starts_with("50130"));
    for (auto const& argument : finding.message.arguments) {
      if (argument.name == "parameter") found.push_back(argument.value.written().substr(12));
    }
  }
  return found;
}

std::string const trapez = "prog_start.slope.profile 1\n";

}  // namespace

TEST_CASE("a weight of accelerating alone does not limit the deceleration") {
  // 150 %: 1500 and 6000 of at most 4000 mm/s².
  CHECK(limited(trapez, "G131=150\n") == tests::Lines{"slope_profil.a_brems"});
  CHECK(limited(trapez + "prog_start.slope.acceleration 1\n", "G131=150\n").empty());
  CHECK(limited(trapez + "prog_start.slope.acceleration 2\n", "G131=150\n") ==
        tests::Lines{"slope_profil.a_brems"});
}

TEST_CASE("a weight of one ramp time does not limit the others") {
  // 25 %: 12.5 ms and, of tr_beschl_ab, 5 of at least 10 ms.
  CHECK(limited(trapez, "G133=25\n") == tests::Lines{"slope_profil.tr_beschl_ab"});
  CHECK(limited(trapez + "prog_start.slope.ramp_time 1\n", "G133=25\n").empty());
  CHECK(limited(trapez + "prog_start.slope.ramp_time 2\n", "G133=25\n") ==
        tests::Lines{"slope_profil.tr_beschl_ab"});
  CHECK(limited(trapez + "prog_start.slope.ramp_time 4\n", "G133=25\n").empty());
}

TEST_CASE("after #SLOPE with a type weights are of all, after #SLOPE DEFAULT as the channel list says") {
  std::string const up_alone = trapez + "prog_start.slope.acceleration 1\n";
  CHECK(limited(up_alone, "#SLOPE [TYPE=TRAPEZ]\nG131=150\n") == tests::Lines{"slope_profil.a_brems"});
  CHECK(limited(up_alone, "#SLOPE [TYPE=TRAPEZ]\n#SLOPE DEFAULT\nG131=150\n").empty());
}

TEST_CASE("with STEP a deceleration of 0 is that of accelerating") {
  std::string const down_alone = "prog_start.slope.profile 0\nprog_start.slope.acceleration 2\n";
  // d_stufe_1 is 4000, d_stufe_2 is 0: a_stufe_2 counts, 2000.
  CHECK(limited(down_alone, "G131=150\n") == tests::Lines{"lslope_profil.d_stufe_1"});
  CHECK(limited("prog_start.slope.profile 0\nprog_start.slope.acceleration 1\n", "G131=150\n").empty());
  CHECK(limited("prog_start.slope.profile 0\nprog_start.slope.acceleration 1\n", "G131=250\n") ==
        tests::Lines{"lslope_profil.a_stufe_1"});
}

}  // namespace weighted_values_test
