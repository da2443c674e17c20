// What the lists of an axis and its channel say about velocity, acceleration and jerk. Defaults and limits:
// manual "Axis parameters", pages of the parameters.
#include "support/catch.hpp"
#include "support/checked.hpp"
#include "validator/check.hpp"
#include "validator/views/driven_value.hpp"

namespace axis_dynamics_test {

namespace {

using namespace axisc;
using tests::Checked;

machine::AxisDynamics dynamics_of(std::string const& lines) {
  Checked const checked({{"x.lis", lines}}, "x.lis");
  CHECK(checked.found().empty());
  REQUIRE(checked.result.machine);
  return checked.result.machine->axes.at(0).dynamics;
}

std::string gear(std::string const& lines) {
  std::string list;
  std::size_t begin = 0;
  while (begin < lines.size()) {
    auto const end = lines.find(';', begin);
    list += "getriebe[0]." + lines.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return list;
}

}  // namespace

TEST_CASE("a list that says nothing moves with the control's defaults") {
  auto const found = dynamics_of("kopf.achs_nr 1\n");
  CHECK(found.feed.velocity == 200000);
  CHECK(found.rapid.velocity == 166666);
  for (auto const* const motion : {&found.feed, &found.rapid}) {
    for (auto const* const stages : {&motion->step_up, &motion->step_down}) {
      CHECK(stages->first == 1000);
      CHECK(stages->second == 1000);
      CHECK(stages->changeover == 100000);
    }
    double const time = motion == &found.feed ? 50000 : 10000;
    for (auto const* const ramp : {&motion->up, &motion->down}) {
      CHECK(ramp->acceleration == 1000);
      CHECK(ramp->build_up == time);
      CHECK(ramp->take_back == time);
    }
  }
  CHECK(found.curve_ramp_time == 10000);
  CHECK(found.highest_acceleration == 1000);
  CHECK(found.shortest_ramp_time == 10000);
  CHECK_FALSE(found.weighted_acceleration);
  CHECK(found.shortest_weighted_ramp_time == 10000);
  CHECK(found.acceleration_transition_weight == 0);
  CHECK(found.curvature_transition_weight == 1000);
  CHECK(found.corner_jerk == 0);
  CHECK(found.curvature_jerk == 0);
  CHECK(found.exact_stop_window == 500);
}

TEST_CASE("each parameter of an axis list reaches its value") {
  auto const found = dynamics_of(gear(
      "dynamik.a_max 9000;dynamik.tr_min 1000;dynamik.vb_max 900000;vb_eilgang 800000;"
      "lslope_profil.a_stufe_1 1100;lslope_profil.a_stufe_2 1200;lslope_profil.vb_stufe_1_2 130000;"
      "lslope_profil.d_stufe_1 1400;lslope_profil.d_stufe_2 1500;lslope_profil.a_grenz_stufe_1 1600;"
      "lslope_profil.a_grenz_stufe_2 1700;lslope_profil.vb_grenz_stufe_1_2 180000;"
      "lslope_profil.d_grenz_stufe_1 1900;lslope_profil.d_grenz_stufe_2 2000;slope_profil.a_beschl 2100;"
      "slope_profil.a_brems 2200;slope_profil.a_grenz 2300;slope_profil.tr_beschl_zu 24000;"
      "slope_profil.tr_beschl_ab 25000;slope_profil.tr_brems_zu 26000;slope_profil.tr_brems_ab 27000;"
      "slope_profil.tr_grenz 28000;dynamik.tr_geom 29000;dynamik.a_w_max 3000;dynamik.tr_w_min 3100;"
      "dynamik.a_trans_weight 320;dynamik.r_trans_weight 330;dynamik.j_trans_c0 34.5;dynamik.j_trans_c1 35.5;"
      "window 360;"));
  CHECK(found.feed.velocity == 900000);
  CHECK(found.rapid.velocity == 800000);
  CHECK(found.feed.step_up.first == 1100);
  CHECK(found.feed.step_up.second == 1200);
  CHECK(found.feed.step_up.changeover == 130000);
  CHECK(found.feed.step_down.first == 1400);
  CHECK(found.feed.step_down.second == 1500);
  CHECK(found.feed.step_down.changeover == 130000);
  CHECK(found.rapid.step_up.first == 1600);
  CHECK(found.rapid.step_up.second == 1700);
  CHECK(found.rapid.step_up.changeover == 180000);
  CHECK(found.rapid.step_down.first == 1900);
  CHECK(found.rapid.step_down.second == 2000);
  CHECK(found.feed.up.acceleration == 2100);
  CHECK(found.feed.down.acceleration == 2200);
  CHECK(found.rapid.up.acceleration == 2300);
  CHECK(found.rapid.down.acceleration == 2300);
  CHECK(found.feed.up.build_up == 24000);
  CHECK(found.feed.up.take_back == 25000);
  CHECK(found.feed.down.build_up == 26000);
  CHECK(found.feed.down.take_back == 27000);
  CHECK(found.rapid.up.build_up == 28000);
  CHECK(found.rapid.down.take_back == 28000);
  CHECK(found.curve_ramp_time == 29000);
  CHECK(found.weighted_acceleration == 3000);
  CHECK(found.shortest_weighted_ramp_time == 3100);
  CHECK(found.acceleration_transition_weight == 320);
  CHECK(found.curvature_transition_weight == 330);
  CHECK(found.corner_jerk == 34.5);
  CHECK(found.curvature_jerk == 35.5);
  CHECK(found.exact_stop_window == 360);
}

TEST_CASE("an acceleration of the slope STEP that is 0 for slowing down is that for speeding up") {
  auto const found = dynamics_of(
      gear("dynamik.a_max 9000;lslope_profil.a_stufe_1 3000;lslope_profil.a_stufe_2 2000;"
           "lslope_profil.d_stufe_1 0;lslope_profil.d_stufe_2 500;lslope_profil.a_grenz_stufe_1 4000;"));
  CHECK(found.feed.step_down.first == 3000);
  CHECK(found.feed.step_down.second == 500);
  CHECK(found.rapid.step_down.first == 4000);
}

TEST_CASE("the limits of an axis cap what its list says where the control corrects it") {
  // 110276: P-AXIS-00199 is raised to 00201; 110406: so is 00293.
  Checked const checked({{"x.lis", gear("dynamik.a_max 500;dynamik.tr_min 60000;")}}, "x.lis");
  // The defaults of accelerations and ramp times are beyond these limits without any finding.
  REQUIRE(checked.result.machine);
  auto const& found = checked.result.machine->axes.at(0).dynamics;
  CHECK(found.feed.step_up.first == 500);
  CHECK(found.rapid.step_down.second == 500);
  CHECK(found.feed.down.acceleration == 500);
  CHECK(found.feed.up.build_up == 60000);
  CHECK(found.rapid.down.take_back == 60000);
  CHECK(found.curve_ramp_time == 60000);
  CHECK(found.shortest_weighted_ramp_time == 60000);
  CHECK(dynamics_of(gear("dynamik.vb_max 100000;vb_eilgang 90000;")).rapid.velocity == 90000);
}

TEST_CASE("a machine file names the channel list of a group") {
  std::map<std::string, std::string> const files = {
      {"machine.json",
       R"({"axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}], "groups": [)"
       R"({"axes": ["X"], "channel_list": "sda.lis"}, {"axes": ["Y"]}]})"},
      {"x.lis", "kopf.achs_nr 1\n"},
      {"y.lis", "kopf.achs_nr 2\n"},
      {"sda.lis", "prog_start.slope.profile 1\ntrans_limit_with_curvature 3 ( P-CHAN-00245\n"}};
  Checked const checked(files, "machine.json");
  CHECK(checked.found().empty());
  REQUIRE(checked.result.machine);
  auto const& groups = checked.result.machine->groups;
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].dynamics.slope == machine::Slope::trapez);
  CHECK(groups[0].dynamics.is_from_list);
  REQUIRE(groups[0].uncomputed.size() == 1);
  CHECK(groups[0].uncomputed[0].number == "P-CHAN-00245");
  CHECK(groups[0].uncomputed[0].file == "sda.lis");
  CHECK(groups[0].uncomputed[0].line == 2);
  CHECK(groups[0].uncomputed[0].line_text == "trans_limit_with_curvature 3 ( P-CHAN-00245");
  CHECK(groups[1].dynamics.slope == machine::Slope::step);
  CHECK_FALSE(groups[1].dynamics.is_from_list);
  // The image holds the lists of axes alone.
  CHECK(checked.result.machine->lists.size() == 2);
}

TEST_CASE("a channel list of a machine file that is missing or is none is an error at its name") {
  auto const with = [](std::string const& list) {
    Checked const checked(
        {{"machine.json",
          R"({"axes": [{"name": "X", "list": "x.lis"}], "groups": [{"axes": ["X"], "channel_list": ")" +
              list + R"("}]})"},
         {"x.lis", "kopf.achs_nr 1\n"},
         {"sda.lis", "gruppe[0].achse[0].log_achs_nr 1\nprog_start.slope.profile x1\n"}},
        "machine.json");
    return checked.found();
  };
  CHECK(with("sda_.lis") == tests::Lines{"1:87 AX4020"});
  CHECK(with("x.lis") == tests::Lines{"1:87 AX4020"});
  // The list itself is checked like any other channel list.
  CHECK(with("sda.lis") == tests::Lines{"sda.lis:2:26 AX2003"});
}

TEST_CASE(
    "channels of a start-up list have their lists, those of all channels and the buffer of the start-up "
    "list") {
  Checked const checked(
      {{"hochlauf.lis",
        "kanal_anzahl 2\nsda_mds[0] sda1.lis\nsda_mds[1] sda2.lis\ndefault_sda_mds all.lis\n"
        "zahl_mds 2\nachs_mds[0] x.lis\nachs_mds[1] y.lis\n"
        "configuration.channel[0].interpolator.function FCT_LOOK_AHEAD_HIGH\n"
        "configuration.channel[1].interpolator.function FCT_LOOK_AHEAD_HIGH\n"},
       {"sda1.lis",
        "gruppe[0].achs_anzahl 1\ngruppe[0].achse[0].log_achs_nr 1\nprog_start.slope.profile 2\n"},
       {"sda2.lis",
        "gruppe[0].achs_anzahl 1\ngruppe[0].achse[0].log_achs_nr 2\n"
        "configuration.interpolator.function FCT_LOOK_AHEAD_LOW\n"},
       {"all.lis", "prog_start.slope.profile 1\nexact_stop_after_g00 1\n"},
       {"x.lis", "kopf.achs_nr 1\n"},
       {"y.lis", "kopf.achs_nr 2\n"}},
      "hochlauf.lis");
  REQUIRE(checked.result.machine);
  auto const& groups = checked.result.machine->groups;
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].dynamics.slope == machine::Slope::sin2);
  CHECK(groups[1].dynamics.slope == machine::Slope::trapez);
  CHECK(groups[0].dynamics.stops_after_rapid);
  CHECK(groups[0].dynamics.look_ahead_blocks == 190);
  CHECK(groups[1].dynamics.look_ahead_blocks == 30);
}

TEST_CASE("before V2.11.28 the look-ahead buffer has 70 blocks") {
  auto const blocks = [](std::string const& build) {
    validator::CheckOptions options;
    options.build = validator::parse_build_version(build);
    Checked const checked({{"x.lis", "kopf.achs_nr 1\n"}}, "x.lis", options);
    REQUIRE(checked.result.machine);
    return checked.result.machine->groups.at(0).dynamics.look_ahead_blocks;
  };
  CHECK(blocks("V2.11.2040.04") == 70);
  CHECK(blocks("V2.11.2810.02") == 120);
  CHECK(blocks("V3.1.3080.00") == 120);
}

TEST_CASE("parameters of an axis that no plan computes are named") {
  Checked const checked({{"x.lis",
                          "dynamic_weighting.enable 1\ngetriebe[0].slope_profil.j_accel 5\n"
                          "getriebe[0].slope_profil.j_decel 0\ngetriebe[0].beschl_kennlinie.typ 2\n"}},
                        "x.lis");
  REQUIRE(checked.result.machine);
  std::vector<std::string> numbers;
  for (auto const& parameter : checked.result.machine->axes.at(0).uncomputed)
    numbers.push_back(parameter.number);
  CHECK(numbers == std::vector<std::string>{"P-AXIS-00431", "P-AXIS-00202", "P-AXIS-00561"});
}

TEST_CASE("what counts of each value, what caps it, and the jerk of its ramp") {
  // Each value has another number, all within P-AXIS-00008, 00201 and 00212.
  std::string const lines =
      "dynamik.a_max 9000;dynamik.tr_min 1000;dynamik.vb_max 500000;vb_eilgang 400000;"
      "lslope_profil.a_stufe_1 1001;lslope_profil.a_stufe_2 1002;lslope_profil.d_stufe_1 1003;"
      "lslope_profil.d_stufe_2 1004;lslope_profil.a_grenz_stufe_1 1005;lslope_profil.a_grenz_stufe_2 1006;"
      "lslope_profil.d_grenz_stufe_1 1007;lslope_profil.d_grenz_stufe_2 1008;slope_profil.a_beschl 2000;"
      "slope_profil.a_brems 3000;slope_profil.a_grenz 4000;slope_profil.tr_beschl_zu 10000;"
      "slope_profil.tr_beschl_ab 20000;slope_profil.tr_brems_zu 30000;slope_profil.tr_brems_ab 40000;"
      "slope_profil.tr_grenz 50000;dynamik.tr_geom 25000;dynamik.tr_w_min 7000;dynamik.a_w_max 8000;";
  auto const dynamics = dynamics_of(gear(lines));
  struct Row {
    std::string name;
    double counts;
    std::string cap;
    std::optional<double> jerk = {};  // a/tr
  };
  for (auto const& row : {Row{"vb_eilgang", 400000, "P-AXIS-00212"},
                          Row{"lslope_profil.a_stufe_1", 1001, "P-AXIS-00008"},
                          Row{"lslope_profil.a_stufe_2", 1002, "P-AXIS-00008"},
                          Row{"lslope_profil.d_stufe_1", 1003, "P-AXIS-00008"},
                          Row{"lslope_profil.d_stufe_2", 1004, "P-AXIS-00008"},
                          Row{"lslope_profil.a_grenz_stufe_1", 1005, "P-AXIS-00008"},
                          Row{"lslope_profil.a_grenz_stufe_2", 1006, "P-AXIS-00008"},
                          Row{"lslope_profil.d_grenz_stufe_1", 1007, "P-AXIS-00008"},
                          Row{"lslope_profil.d_grenz_stufe_2", 1008, "P-AXIS-00008"},
                          Row{"slope_profil.a_beschl", 2000, "P-AXIS-00008"},
                          Row{"slope_profil.a_brems", 3000, "P-AXIS-00008"},
                          Row{"slope_profil.a_grenz", 4000, "P-AXIS-00008"},
                          Row{"slope_profil.tr_beschl_zu", 10000, "P-AXIS-00201", 200000},
                          Row{"slope_profil.tr_beschl_ab", 20000, "P-AXIS-00201", 100000},
                          Row{"slope_profil.tr_brems_zu", 30000, "P-AXIS-00201", 100000},
                          Row{"slope_profil.tr_brems_ab", 40000, "P-AXIS-00201", 75000},
                          Row{"slope_profil.tr_grenz", 50000, "P-AXIS-00201", 80000},
                          Row{"dynamik.tr_geom", 25000, "P-AXIS-00201", 80000},
                          Row{"dynamik.tr_w_min", 7000, "P-AXIS-00201"},
                          Row{"dynamik.a_w_max", 8000, "P-AXIS-00008"}}) {
    INFO(row.name);
    auto const found = validator::driven_value(dynamics, "getriebe[]." + row.name);
    REQUIRE(found);
    CHECK(found->counts == row.counts);
    CHECK(found->cap == row.cap);
    REQUIRE(found->jerk.has_value() == row.jerk.has_value());
    if (row.jerk) CHECK(*found->jerk == Approx(*row.jerk));
  }
  CHECK_FALSE(validator::driven_value(dynamics, "filter[].order"));
}

}  // namespace axis_dynamics_test
