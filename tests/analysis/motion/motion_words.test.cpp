// Words of a program that say how its path is driven, as the blocks get them. Meanings are those of the
// manual "Programming" of the TF5200, on the pages that the table names.
#include "schema/motion_words.hpp"

#include "analysis/motion/program/interpreter.hpp"
#include "channels.hpp"
#include "support/catch.hpp"

#include <set>
#include <tuple>

#include <fmt/format.h>

namespace axisc::motion::motion_words_test {
namespace {

struct Blocks final : PathListener {
  void motion(ProgrammedBlock const& block) override { all.push_back(block); }
  void command(FilterChange const& /*change*/) override {}
  void end() override {}
  std::vector<ProgrammedBlock> all;
};

struct Followed {
  std::vector<ProgrammedBlock> blocks;
  std::vector<std::string> problems;  ///< "line:column code word"
  std::optional<double> rounding;

  [[nodiscard]] BlockDynamics const& dynamics(std::size_t block) const {
    REQUIRE(block < blocks.size());
    REQUIRE(blocks[block].dynamics != nullptr);
    return *blocks[block].dynamics;
  }
};

Followed follow(std::string const& program, machine::ChannelDynamics const& dynamics = {},
                bool sharp_corners = false) {
  Blocks blocks;
  Followed result;
  ProgramChannel const channel{.axes = {"X", "Y"},
                               .rotary = {false, false},
                               .cycle_time = {},
                               .read_filter_command = test::filter_command_reader({}),
                               .dynamics = dynamics,
                               .sharp_corners = sharp_corners};
  std::tie(result.problems, result.rounding) = test::interpreted(channel, blocks, program);
  result.blocks = blocks.all;
  return result;
}

using Lines = std::vector<std::string>;
using Flags = std::vector<bool>;

Flags stops(Followed const& followed) {
  Flags flags;
  for (auto const& block : followed.blocks) flags.push_back(block.exact_stop);
  return flags;
}

Flags late(Followed const& followed) {
  Flags flags;
  for (auto const& block : followed.blocks) flags.push_back(block.brakes_late);
  return flags;
}

}  // namespace

TEST_CASE("motion words: a program without any says nothing about its blocks") {
  auto const found = follow("G01 F60 X1\nG00 X2\n");
  REQUIRE(found.blocks.size() == 2);
  CHECK(found.blocks[0].dynamics == nullptr);
  CHECK_FALSE(found.blocks[0].rapid);
  CHECK(found.blocks[1].rapid);
  CHECK(stops(found) == Flags{false, false});
  CHECK(late(found) == Flags{false, false});
}

TEST_CASE("motion words: G60 stops at the end of its block, G360 of all up to G359") {
  auto const found = follow("G01 F60 G60 X1\nX2\nX3 G60\nG360\nX4\nX5\nG359 X6\n");
  CHECK(found.problems.empty());
  CHECK(stops(found) == Flags{true, false, true, true, true, false});
}

TEST_CASE("motion words: G60 without motion is the control's error 20003") {
  CHECK(follow("G01 F60 X1\nG60\nX2\n").problems == Lines{"2:1 AX9008 G60"});
  CHECK(follow("G60 G04 X1\n").problems == Lines{"1:1 AX9008 G60"});
}

TEST_CASE("motion words: with P-CHAN-00235 every G00 ends with an exact stop") {
  auto const found = follow("G00 X1\nG01 F60 X2\nG00 X3\n", {.stops_after_rapid = true, .vector = {}});
  CHECK(stops(found) == Flags{true, false, true});
}

TEST_CASE("motion words: G901 brakes behind a block, G09 by the end of its own, G900 always") {
  auto const found = follow("G01 F60 G901 X1\nX2 G09\nX3\nG900 X4\nG09 X5\n");
  CHECK(found.problems.empty());
  CHECK(late(found) == Flags{true, false, true, false, false});
  CHECK(follow("G08 G01 F60 X1\n").problems.empty());
}

TEST_CASE("motion words: those that exclude each other in a block are refused") {
  // 20109 and 20124 of the control.
  CHECK(follow("G01 F60 X1 G08 G09\n").problems == Lines{"1:16 AX9008 G09"});
  CHECK(follow("G115=2 G117\n").problems == Lines{"1:8 AX9008 G117"});
}

TEST_CASE("motion words: what the plan cannot follow is refused at the word, with what helps") {
  std::string const program =
      "G64\nG193 X1\nG293 X1\nG13\nG61 X1\nG261\n#CONTOUR MODE ON [DEV PATH_DEV=0.1]\nG116 X1\n#DYNAMIC "
      "WEIGHT ON\n";
  CHECK(follow(program).problems == Lines{"1:1 AX9008 G64", "2:1 AX9008 G193", "3:1 AX9008 G293",
                                          "4:1 AX9008 G13", "5:1 AX9008 G61", "6:1 AX9008 G261",
                                          "7:1 AX9008 #CONTOUR", "8:1 AX9008 G116", "9:1 AX9008 #DYNAMIC"});
}

TEST_CASE("motion words: what changes nothing is accepted without a word") {
  CHECK(follow("G08\nG900\nG12\nG260\n#CONTOUR MODE OFF\n#CONTOUR MODE [DEV PATH_DEV=0.1]\nG334=50\nG339=80\n"
               "G01 F60 X1 G333 Y50\nG338 X70\n")
            .problems.empty());
  // Axis words behind G333 are percentages.
  auto const found = follow("G01 F60 G333 X50\nG338 X50 Y50\nX1\n");
  REQUIRE(found.blocks.size() == 1);
  CHECK(found.blocks[0].end[0] == units_per_mm);
}

TEST_CASE("motion words: with sharp corners a rounded corner is followed, with its bound") {
  auto const at_most = [](std::string const& program) { return follow(program, {}, true).rounding; };
  CHECK(at_most("G01 F60 X1\nY1\n") == std::nullopt);
  CHECK(at_most("G01 F60 G61 X1\nY1\n") == 1);
  CHECK(at_most("#CONTOUR MODE [DEV PATH_DEV=0.1]\nG01 F60 G61 X1\nY1\n") == 0.1);
  CHECK(at_most("G70 #CONTOUR MODE ON [DEV PATH_DEV=0.1]\nG01 F60 X1\n#CONTOUR MODE OFF\nY1\n") == 2.54);
  CHECK(at_most("G261\nG260 G01 F60 X1\nY1\n") == std::nullopt);
  CHECK(follow("G61 G01 F60 X1\nG261\n#CONTOUR MODE ON\n", {}, true).problems.empty());
}

TEST_CASE("motion words: #SLOPE by type, by number and back to the channel's") {
  using enum machine::Slope;
  auto const found = follow(
      "G01 F60 X1\n#SLOPE [TYPE=TRAPEZ]\nX2\n#SLOPE[TYPE=SIN2 NO_OPT=1]\nX3\n#SLOPE [ TYPE = HSC ]\nX4\n"
      "#SET SLOPE PROFIL[0]\nX5\nP1=2\n#SET SLOPE PROFIL [P1]\nX6\n#SLOPE DEFAULT\nX7\n",
      {.slope = trapez, .constant_ramp_times = true, .vector = {}});
  CHECK(found.problems.empty());
  REQUIRE(found.blocks.size() == 7);
  CHECK(found.blocks[0].dynamics == nullptr);
  std::vector<machine::Slope> slopes;
  for (std::size_t i = 1; i < 7; ++i) {
    slopes.push_back(found.dynamics(i).slope);
    CHECK(found.dynamics(i).constant_ramp_times);
  }
  CHECK(slopes == std::vector{trapez, sin2, hsc, step, sin2, trapez});
}

TEST_CASE("motion words: another type or number of a slope is refused") {
  // 120020 and 120178 of the control.
  for (std::string const command :
       {"#SLOPE [TYPE=ROUND]", "#SLOPE", "#SLOPE [TYP=STEP]", "#SLOPE [TYPE=STEP", "#SLOPE DEFAULT X1",
        "#SET SLOPE PROFIL[4]", "#SET SLOPE PROFIL[1.5]", "#SET SLOPE PROFIL 1"}) {
    INFO(command);
    auto const word = command.substr(0, command.find(' '));
    CHECK(follow(command + "\n").problems == Lines{"1:1 AX9008 " + word});
  }
}

TEST_CASE("motion words: weights of accelerations") {
  auto const found = follow("G130 X50\nG01 F60 X1\nG130 Y=80 G131=120\nX2 Y2\nG131=30 X3\n");
  CHECK(found.problems.empty());
  REQUIRE(found.blocks.size() == 3);
  CHECK(found.dynamics(0).feed[0].up.acceleration == 50);
  CHECK(found.dynamics(0).feed[0].down.acceleration == 50);
  CHECK(found.dynamics(0).feed[1].up.acceleration == 100);
  CHECK(found.dynamics(0).rapid[0].up.acceleration == 100);
  CHECK(found.dynamics(0).feed[0].up.build_up == 100);
  CHECK(found.dynamics(1).feed[0].up.acceleration == 120);
  CHECK(found.dynamics(1).feed[1].down.acceleration == 120);
  // Beside G131 an axis word is a position.
  CHECK(found.blocks[2].end[0] == 3 * units_per_mm);
  CHECK(found.dynamics(2).feed[0].up.acceleration == 30);
}

TEST_CASE("motion words: an axis keeps its weight until it is named again") {
  auto const found = follow("G130 X50\nG130 Y70\nG01 F60 X1\nG130 X200\nX2\n");
  CHECK(found.dynamics(0).feed[0].up.acceleration == 50);
  CHECK(found.dynamics(0).feed[1].up.acceleration == 70);
  // Always of the value of the list: 200 % of it, not of the half.
  CHECK(found.dynamics(1).feed[0].up.acceleration == 200);
}

TEST_CASE("motion words: weights of ramp times, of curves and of G00") {
  auto const found =
      follow("G132 X150 Y250\nG134=300\nG230 X40\nG231=60\nG230 Y90\nG233=70\nG01 F60 X1\nG133=10\nX2\n");
  CHECK(found.problems.empty());
  auto const& first = found.dynamics(0);
  CHECK(first.feed[0].up.build_up == 150);
  CHECK(first.feed[1].down.take_back == 250);
  CHECK(first.feed[0].up.acceleration == 100);
  CHECK(first.feed[0].curve_ramp == 300);
  CHECK(first.rapid[1].curve_ramp == 300);
  CHECK(first.rapid[0].up.acceleration == 60);
  CHECK(first.rapid[1].down.acceleration == 90);
  CHECK(first.rapid[0].up.build_up == 70);
  CHECK(first.rapid[1].down.take_back == 70);
  CHECK(found.dynamics(1).feed[0].down.build_up == 10);
  CHECK(found.dynamics(1).rapid[0].down.build_up == 70);
}

TEST_CASE("motion words: P-CHAN-00001 and 00073 say which values weights are of, until #SLOPE with a type") {
  auto const found = follow(
      "G131=50 G133=200\nG01 F60 X1\n#SLOPE [TYPE=TRAPEZ]\nG131=60 G133=70\nX2\n"
      "#SLOPE DEFAULT\nG131=80 G133=90\nX3\n",
      {.weighted_acceleration = 2, .weighted_ramp = 3, .vector = {}});
  auto const& first = found.dynamics(0).feed[0];
  CHECK(first.up.acceleration == 100);
  CHECK(first.down.acceleration == 50);
  CHECK(first.up.build_up == 100);
  CHECK(first.up.take_back == 100);
  CHECK(first.down.build_up == 200);
  CHECK(first.down.take_back == 100);
  auto const& second = found.dynamics(1).feed[0];
  CHECK(second.up.acceleration == 60);
  CHECK(second.down.take_back == 70);
  auto const& third = found.dynamics(2).feed[0];
  CHECK(third.up.acceleration == 60);
  CHECK(third.down.acceleration == 80);
  CHECK(third.down.build_up == 90);
  CHECK(third.down.take_back == 70);
}

TEST_CASE("motion words: weights of velocities") {
  auto const found = follow("G127 X70 Y60\nG129=25\nG01 F60 X1\nG128=0\nX2\n");
  CHECK(found.problems.empty());
  CHECK(found.dynamics(0).feed[0].velocity == 70);
  CHECK(found.dynamics(0).feed[1].velocity == 60);
  CHECK(found.dynamics(0).rapid[0].velocity == 25);
  CHECK(found.dynamics(1).feed[1].velocity == 0);
}

TEST_CASE("motion words: weights that are none are refused") {
  CHECK(follow("G131=0\n").problems == Lines{"1:1 AX9008 G131"});
  CHECK(follow("G133=-5\n").problems == Lines{"1:1 AX9008 G133"});
  CHECK(follow("G130 X-5\n").problems == Lines{"1:6 AX9008 X-5"});
  CHECK(follow("G131\n").problems == Lines{"1:1 AX9008 G131"});
  CHECK(follow("G131=V.A.X\n").problems == Lines{"1:1 AX9008 G131"});
  CHECK(follow("P1=40\nG131=P1*2 G133 = 50\nG01 F60 X1\n").dynamics(0).feed[0].up.acceleration == 80);
}

TEST_CASE("motion words: functions of the look-ahead") {
  auto const found = follow("G115=8\nG01 F60 X1\nG115=2\nX2\nG115=0\nX3\nG117\nX4\n");
  CHECK(found.problems.empty());
  auto const limits = [&](std::size_t block) {
    return std::pair(found.dynamics(block).limits_corners, found.dynamics(block).limits_curves);
  };
  CHECK(limits(0) == std::pair(false, true));
  CHECK(limits(1) == std::pair(true, false));
  CHECK(limits(2) == std::pair(false, false));
  CHECK(limits(3) == std::pair(true, true));
  CHECK(follow("G115=20\n").problems == Lines{"1:1 AX9008 G115"});
}

TEST_CASE("motion words: limits of the path") {
  machine::ChannelDynamics channel;
  channel.vector = {.velocity = 6000, .acceleration = 3600, .deceleration = 7200};
  auto const found = follow(
      "#VECTOR LIMIT ON [VEL=1200 ACC=7200]\nG01 F60 X1\n#VECTOR LIMIT ON [DEC VEL]\nX2\n"
      "#VECTOR LIMIT OFF\nX3\n#VECTOR LIMIT ON ALL\nX4\n#VECTOR LIMIT OFF [ACC]\nX5\n",
      channel);
  CHECK(found.problems.empty());
  auto const none = VectorLimit::none;
  // mm/min are 1/60 mm/s, mm/min² are 1/3600 mm/s².
  CHECK(found.dynamics(0).vector.velocity == 20);
  CHECK(found.dynamics(0).vector.acceleration == 2);
  CHECK(found.dynamics(0).vector.deceleration == none);
  CHECK(found.dynamics(1).vector.velocity == 100);
  CHECK(found.dynamics(1).vector.acceleration == 2);
  CHECK(found.dynamics(1).vector.deceleration == 2);
  CHECK(found.dynamics(2).vector.velocity == none);
  CHECK(found.dynamics(3).vector.acceleration == 1);
  CHECK(found.dynamics(3).vector.radial_acceleration == Approx(1e8 / 3600));
  CHECK(found.dynamics(4).vector.acceleration == none);
  CHECK(found.dynamics(4).vector.deceleration == 2);
  channel.vector.per_minute = false;
  CHECK(follow("#VECTOR LIMIT ON [ACC=500]\nG01 F60 X1\n", channel).dynamics(0).vector.acceleration == 500);
  for (std::string const rest :
       {"", " ON", " ON []", " ON [JERK=5]", " ON [VEL=0]", " OFF [VEL=5]", " ON ALL X"}) {
    INFO(rest);
    CHECK(follow("#VECTOR LIMIT" + rest + "\n").problems == Lines{"1:1 AX9008 #VECTOR"});
  }
}

TEST_CASE("motion words: the least velocity through corners") {
  auto const found = follow("#TRANSVELMIN ON [600]\nG01 F60 X1\n#TRANSVELMIN ON\nX2\n#TRANSVELMIN OFF\nX3\n");
  CHECK(found.problems.empty());
  CHECK(found.dynamics(0).least_corner_velocity == 10);
  CHECK(found.dynamics(1).least_corner_velocity == 0);
  CHECK(found.dynamics(2).least_corner_velocity == std::nullopt);
  CHECK(follow("G70 #TRANSVELMIN ON [6]\nG01 F60 X1\n").dynamics(0).least_corner_velocity == Approx(2.54));
  CHECK(follow("#TRANSVELMIN ON [-1]\n").problems == Lines{"1:1 AX9008 #TRANSVELMIN"});
}

TEST_CASE("motion words: blocks that were passed on keep what was said before") {
  auto const found = follow("G131=50 G01 F60 X1\nX2\nG131=70 X3\n");
  CHECK(found.blocks[0].dynamics == found.blocks[1].dynamics);
  CHECK(found.dynamics(1).feed[0].up.acceleration == 50);
  CHECK(found.dynamics(2).feed[0].up.acceleration == 70);
}

TEST_CASE("motion words: the table names each word once, and finds it however it is written") {
  std::set<std::string_view> known;
  for (auto const& word : schema::motion_words()) {
    CHECK(known.insert(word.word).second);
    CHECK(word.form.starts_with(word.word));
    CHECK((word.use == schema::WordUse::refused) == (word.refusal != nullptr));
    CHECK(schema::find_motion_word(word.word) == &word);
    CHECK(schema::find_motion_word(word.form.substr(0, word.form.find(','))) == &word);
  }
  CHECK(schema::find_motion_word("g9")->word == "G09");
  CHECK(schema::find_motion_word("#contour mode on")->word == "#CONTOUR MODE ON");
  CHECK(schema::find_motion_word("#CONTOUR MODE [DEV]")->word == "#CONTOUR MODE");
  CHECK(schema::find_motion_word("#SLOPE[TYPE=STEP]")->word == "#SLOPE");
  CHECK(schema::find_motion_word("G01") == nullptr);
  CHECK(schema::find_motion_word("slope") == nullptr);
  CHECK(schema::find_motion_word("") == nullptr);
}

}  // namespace axisc::motion::motion_words_test
