// Each parameter of axis and channel lists that says how fast a path may be driven changes how long a program
// takes: the direction follows from what the manual says of it.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace dynamics_parameters_test {

using namespace axisc::test;

namespace {

enum class Becomes { longer, shorter };

struct Case {
  std::string
      parameter;  ///< with its value: of the axis lists where it begins with getriebe, else of the channel's
  Becomes becomes;
  std::string program;
  std::string axis = {};     ///< lines that both machines have
  std::string channel = {};  ///< likewise
};

std::string const line = "G01 X100 F12000";                   // 200 mm/s
std::string const rapid = "G00 X100";                         // 166 mm/s
std::string const corner = "G01 X20 F6000\nY20";              // 90°
std::string const arc = "G01 X20 F6000\nG03 X10 Y10 I0 J10";  // tangent
std::string const circle = "G02 I10 J0 F60000";
std::string const trapez = "prog_start.slope.profile 1\n";
std::string const quick =
    "getriebe[0].dynamik.a_max 4000\ngetriebe[0].slope_profil.a_beschl "
    "2000\ngetriebe[0].slope_profil.a_brems 2000\n";
std::string const staged =
    "getriebe[0].lslope_profil.a_stufe_2 500\ngetriebe[0].lslope_profil.a_grenz_stufe_2 500\n"
    "getriebe[0].dynamik.a_max 4000\n";

double seconds(Case const& test, bool changed) {
  TemporaryFolder const folder;
  bool const of_axis = test.parameter.starts_with("getriebe");
  auto const line_if = [&](bool condition) { return condition ? test.parameter + "\n" : std::string(); };
  for (std::string const name : {"x.lis", "y.lis"}) {
    folder.write(name, test.axis + line_if(changed && of_axis) + "Ende\n");
  }
  folder.write("sda.lis", test.channel + line_if(changed && !of_axis) + "Ende\n");
  folder.write(
      "machine.json",
      R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}],
                   "groups": [{"axes": ["X", "Y"], "channel_list": "sda.lis"}]})");
  folder.write("p.nc", "G17 G71 G91 G94\n" + test.program + "\nM30\n");
  auto const outcome = run_axisc({"simulate", "machine.json", "--program", "p.nc", "--format", "json"},
                                 in_folder(folder.path()));
  INFO(test.parameter << "\n" << outcome.err);
  REQUIRE(outcome.status == 0);
  double sum = 0;
  auto const answer = nlohmann::json::parse(outcome.out);
  for (auto const& block : answer["blocks"]) sum += block["time_s"].get<double>();
  return sum;
}

std::string short_blocks() {
  std::string blocks = "G01 F12000 X0.02";
  for (int i = 0; i < 300; ++i) blocks += "\nX0.02";
  return blocks;
}

}  // namespace

TEST_CASE("each parameter of the dynamics changes how long a program takes") {
  std::string const g = "getriebe[0].";
  std::string const t = g + "slope_profil.";
  std::string const l = g + "lslope_profil.";
  std::string const d = g + "dynamik.";
  using enum Becomes;
  std::vector<Case> const cases = {
      {.parameter = d + "vb_max 300000", .becomes = shorter, .program = "G01 X200 F60000"},
      {.parameter = g + "vb_eilgang 100000", .becomes = longer, .program = rapid},
      {.parameter = l + "a_stufe_1 500", .becomes = longer, .program = line},
      {.parameter = l + "a_stufe_2 500", .becomes = longer, .program = line},
      {.parameter = l + "vb_stufe_1_2 50000", .becomes = longer, .program = line, .axis = staged},
      {.parameter = l + "d_stufe_1 3000", .becomes = shorter, .program = line, .axis = staged},
      {.parameter = l + "d_stufe_2 3000", .becomes = shorter, .program = line, .axis = staged},
      {.parameter = l + "a_grenz_stufe_1 500", .becomes = longer, .program = rapid},
      {.parameter = l + "a_grenz_stufe_2 500", .becomes = longer, .program = rapid},
      {.parameter = l + "vb_grenz_stufe_1_2 50000", .becomes = longer, .program = rapid, .axis = staged},
      {.parameter = l + "d_grenz_stufe_1 3000", .becomes = shorter, .program = rapid, .axis = staged},
      {.parameter = l + "d_grenz_stufe_2 3000", .becomes = shorter, .program = rapid, .axis = staged},
      {.parameter = t + "a_beschl 500", .becomes = longer, .program = line, .channel = trapez},
      {.parameter = t + "a_brems 500", .becomes = longer, .program = line, .channel = trapez},
      {.parameter = t + "a_grenz 500", .becomes = longer, .program = rapid, .channel = trapez},
      {.parameter = t + "tr_beschl_zu 100000", .becomes = longer, .program = line, .channel = trapez},
      {.parameter = t + "tr_beschl_ab 100000", .becomes = longer, .program = line, .channel = trapez},
      {.parameter = t + "tr_brems_zu 100000", .becomes = longer, .program = line, .channel = trapez},
      {.parameter = t + "tr_brems_ab 100000", .becomes = longer, .program = line, .channel = trapez},
      {.parameter = t + "tr_grenz 100000", .becomes = longer, .program = rapid, .channel = trapez},
      {.parameter = d + "tr_geom 500000", .becomes = longer, .program = circle, .channel = trapez},
      {.parameter = d + "a_max 500", .becomes = longer, .program = line},
      {.parameter = d + "tr_min 100000", .becomes = longer, .program = line, .channel = trapez},
      {.parameter = d + "a_w_max 3000",
       .becomes = longer,
       .program = "G131=200\n" + line,
       .axis = quick,
       .channel = trapez},
      {.parameter = d + "tr_w_min 40000",
       .becomes = longer,
       .program = "G133=10\n" + line,
       .channel = trapez},
      {.parameter = d + "a_trans_weight 500", .becomes = shorter, .program = corner, .channel = trapez},
      {.parameter = d + "r_trans_weight 0",
       .becomes = longer,
       .program = arc,
       .channel = trapez + "corr_v_trans_jerk 1\n"},
      {.parameter = d + "j_trans_c0 500",
       .becomes = shorter,
       .program = corner,
       .channel = trapez + "mode_trans_jerk 2\n"},
      {.parameter = d + "j_trans_c1 500",
       .becomes = shorter,
       .program = arc,
       .channel = trapez + "corr_v_trans_jerk 1\nmode_trans_jerk 2\n"},
      {.parameter = "prog_start.slope.profile 1", .becomes = longer, .program = line},
      {.parameter = "prog_start.slope.mode_ramp_time 1",
       .becomes = longer,
       .program = "G01 X2 F6000",
       .channel = trapez},
      {.parameter = "prog_start.slope.acceleration 1",
       .becomes = shorter,
       .program = "G131=50\n" + line,
       .channel = trapez},
      {.parameter = "prog_start.slope.ramp_time 2",
       .becomes = shorter,
       .program = "G133=200\n" + line,
       .channel = trapez},
      {.parameter = "corr_v_trans_jerk 1",
       .becomes = longer,
       .program = arc,
       .axis = d + "r_trans_weight 0\n",
       .channel = trapez},
      {.parameter = "mode_trans_jerk 1",
       .becomes = longer,
       .program = arc,
       .axis = d + "a_trans_weight 800\n" + d + "r_trans_weight 200\n",
       .channel = trapez + "corr_v_trans_jerk 1\n"},
      {.parameter = "exact_stop_after_g00 1", .becomes = longer, .program = rapid + "\nG01 X50 F6000"},
      {.parameter = "configuration.interpolator.function FCT_LOOK_AHEAD_LOW",
       .becomes = longer,
       .program = short_blocks()},
      {.parameter = "configuration.interpolator.number_blocks_lah 20",
       .becomes = longer,
       .program = short_blocks(),
       .channel = "configuration.interpolator.function FCT_LOOK_AHEAD_CUSTOM\n"},
      {.parameter = "vector.velocity 3000", .becomes = longer, .program = "#VECTOR LIMIT ON ALL\n" + line},
      {.parameter = "vector.acceleration 1800000",
       .becomes = longer,
       .program = "#VECTOR LIMIT ON ALL\n" + line},
      {.parameter = "vector.deceleration 1800000",
       .becomes = longer,
       .program = "#VECTOR LIMIT ON ALL\n" + line},
      {.parameter = "vector.radial_acceleration 360000",
       .becomes = longer,
       .program = "#VECTOR LIMIT ON ALL\n" + circle},
      {.parameter = "vector.cir_radial_acc_limit 1",
       .becomes = longer,
       .program = "#VECTOR LIMIT ON ALL\n" + circle,
       .channel = "vector.acceleration 360000\nvector.deceleration 360000\n"},
      {.parameter = "vector.acc_dec_unit MM_S2",
       .becomes = shorter,
       .program = "#VECTOR LIMIT ON ALL\n" + line,
       .channel = "vector.acceleration 1000\n"}};
  for (Case const& test : cases) {
    double const before = seconds(test, false);
    double const after = seconds(test, true);
    INFO(test.parameter << ": " << before << " s, then " << after << " s");
    CHECK((test.becomes == longer ? after > before + 1e-6 : after < before - 1e-6));
  }
}

}  // namespace dynamics_parameters_test
