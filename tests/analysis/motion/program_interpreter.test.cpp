#include "analysis/motion/program/interpreter.hpp"
#include "channels.hpp"
#include "support/catch.hpp"

#include <fmt/format.h>

namespace axisc::motion::program_interpreter_test {
namespace {

/// A program as the path it means, one line per motion or command.
struct Script final : PathListener {
  void motion(ProgrammedBlock const& block) override {
    lines.push_back(fmt::format("{} {} {} {}", block.label, block.end[0] / units_per_mm,
                                block.end[1] / units_per_mm,
                                std::isinf(block.feed) ? "rapid" : fmt::format("{:.6g}", block.feed)));
  }
  void command(FilterChange const& change) override {
    lines.push_back(fmt::format("{} tolerance {:.6g}", change.text, change.tolerance.value_or(0)));
  }
  void end() override { lines.emplace_back("end"); }
  std::vector<std::string> lines;
};

struct Interpreted {
  std::vector<std::string> path;
  std::vector<std::string> problems;  ///< "line:column code word"
};

Interpreted interpret(std::string const& program, bool inch = false) {
  Script script;
  Interpreted result;
  ProgramChannel const channel{.axes = {"X", "Y1"},
                               .rotary = {false, false},
                               .inch = inch,
                               .cycle_time = {},
                               .read_filter_command = test::filter_command_reader({})};
  result.problems = test::interpreted(channel, script, program).first;
  result.path = script.lines;
  return result;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("the subset of NC programs") {
  auto const found = interpret(
      "%MAIN (a square)\n"
      "N010 G00 G90 X1 Y1=2 ; rapid\n"
      "N020 #SLOPE [TYPE=TRAPEZ]\n"
      "N030 #FILTER ON [ORDER=20 AX_DEV=0.001] (smooth)\n"
      "N040 G01 X+5 F600\n"
      "/N050 G91 X-1.5\n"
      "X.5 Y1=-2\n"
      "N060 G90 X0 #FILTER OFF\n"
      "N070 M30\n"
      "N080 X100\n");
  CHECK(found.problems.empty());
  CHECK(found.path == Lines{"N010 1 2 rapid", "#FILTER ON [ORDER=20 AX_DEV=0.001] tolerance 10",
                            "N040 5 2 100", "N050 3.5 2 100", "L7 4 0 100", "N060 0 0 100",
                            "#FILTER OFF tolerance 0", "end"});
}

TEST_CASE("a block over several lines, and a program without M30") {
  auto const found = interpret("G01 X1 \\\n  F60 \\\n  Y1=3\nX2");
  CHECK(found.problems.empty());
  CHECK(found.path == Lines{"L1 1 3 10", "L4 2 3 10", "end"});
}

TEST_CASE("inches") {
  auto const found = interpret("G01 X1 F10\n#FILTER [AX_DEV=0.001]\n", true);
  CHECK(found.path == Lines{"L1 25.4 0 42.3333", "#FILTER [AX_DEV=0.001] tolerance 254", "end"});
}

TEST_CASE("what is ignored is named once, what is refused each time") {
  auto const found = interpret(
      "G01 X1 F60 S1000 M03\n"
      "X2 S2000 M3 Z5\n"
      "G08 X3\n"
      "#SLOPE [TYPE=ROUND]\n"
      "#TIMER START\n"
      "G02 X3\n"
      "P10=5+\n"
      "LL SUB\n"
      "$SWITCH V.P.A\n"
      "XP1\n");
  CHECK(found.problems == Lines{"1:18 AX9007 M03", "2:13 AX9007 Z5", "4:1 AX9008 #SLOPE", "5:1 AX9007 #TIMER",
                                "6:5 AX9008 X3", "7:6 AX9008 +", "8:1 AX9008 LL", "9:1 AX9008 $SWITCH",
                                "10:1 AX9008 XP1"});
}

TEST_CASE("what would change the path is refused by its name") {
  auto const found = interpret(
      "G41 D1\n"
      "G54\n"
      "G92 X5\n"
      "#CS ON [0,0,0,0,0,0]\n"
      "#HSC ON\n"
      "G93\n"
      "G04\n"
      "G04 X-1\n"
      "G01 X1 F100 I5\n"
      "G95 X2 F0.1\n");
  CHECK(found.problems == Lines{"1:1 AX9008 G41", "2:1 AX9008 G54", "3:1 AX9008 G92", "4:1 AX9008 #CS",
                                "5:1 AX9008 #HSC", "6:1 AX9008 G93", "7:1 AX9008 G04", "8:5 AX9008 X-1",
                                "9:13 AX9008 I5", "10:5 AX9008 X2"});
}

TEST_CASE("a word that could only count by leaving out another one is refused") {
  CHECK(interpret("G01 F60 X1 X2\n").problems == Lines{"1:12 AX9008 X2"});
  CHECK(interpret("G01 F60 X1 X=3\n").problems == Lines{"1:12 AX9008 X"});
  CHECK(interpret("G02 F60 X1 I1 I0.5\n").problems == Lines{"1:15 AX9008 I0.5"});
  CHECK(interpret("G02 F60 X1 R1 R2\n").problems == Lines{"1:15 AX9008 R2"});
  CHECK(interpret("G01 F600 F700 X1\n").problems == Lines{"1:10 AX9008 F700"});
  CHECK(interpret("G01 F600 X1 F=600\n").problems == Lines{"1:13 AX9008 F"});
  CHECK(interpret("G95 S500 S600 F0.1 X1\n").problems == Lines{"1:10 AX9008 S600", "1:5 AX9007 S500"});
  CHECK(interpret("G04 X1 X2\n").problems == Lines{"1:8 AX9008 X2"});
  CHECK(interpret("G01 F60 X1 G04 X2\n").problems == Lines{"1:12 AX9008 G04"});
  CHECK(interpret("G01 F60 X1\nX2\nG02 X3 R1\nX4 R1\n").problems.empty());
  CHECK(interpret("G00 G01 F60 X1\n").problems == Lines{"1:5 AX9008 G01"});
  CHECK(interpret("G90 G01 F60 X1 G91\n").problems == Lines{"1:16 AX9008 G91"});
  CHECK(interpret("G17 G18 G01 F60 X1\nG70 G71\nG94 G95\n").problems ==
        Lines{"1:5 AX9008 G18", "2:5 AX9008 G71", "3:5 AX9008 G95"});
  CHECK(interpret("G01 G01 G90 G71 G94 G17 F60 X1\nG00 X2\nG01 X3\n").problems.empty());
}

TEST_CASE("a spindle speed counts with G95, and only otherwise it is ignored") {
  CHECK(interpret("G95 S500 F0.1\nG01 X1\n").problems.empty());
  CHECK(interpret("S500\nG95 F0.1 G01 X1\n").problems.empty());
  CHECK(interpret("S500 G01 F100 X1\n").problems == Lines{"1:1 AX9007 S500"});
  // One warning for all words of its kind.
  CHECK(interpret("S500 G01 F100 X1 M3\n").problems == Lines{"1:18 AX9007 M3"});
  CHECK(interpret("G95 S500 F0.1 G01 X1\nM3\n").problems == Lines{"2:1 AX9007 M3"});
}

TEST_CASE("inches and feed rates per revolution as the program asks for them") {
  // G70: 1 in = 25.4 mm. G95: 0.1 mm at 6000/min are 600 mm/min, 100 units per cycle.
  CHECK(interpret("G70 G01 X1 F10\nG71 X1 F600\n").path == Lines{"L1 25.4 0 42.3333", "L2 1 0 100", "end"});
  CHECK(interpret("G95 G01 X1 F0.1 S6000\nG94 X2 F60\n").path == Lines{"L1 1 0 100", "L2 2 0 10", "end"});
}

TEST_CASE("a motion needs a feed, a command sound keywords") {
  CHECK(interpret("N10 G01 X1\nX2\n").problems == Lines{"1:9 AX9008 X1"});
  CHECK(interpret("G01 X1 F0\n").problems.front() == "1:8 AX9008 F0");
  CHECK(interpret("N10 #FILTER ON [ORDER=999]\n").problems == Lines{"1:23 AX5002 999"});
  CHECK(interpret("G00 X1e300\n").problems.size() == 1);
}

}  // namespace axisc::motion::program_interpreter_test
