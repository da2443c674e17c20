#include "analysis/motion/program/interpreter.hpp"
#include "channels.hpp"
#include "support/catch.hpp"

#include <sstream>

#include <fmt/format.h>

namespace axisc::motion::program_flow_test {
namespace {

/// Where a program goes along X in mm, and what is wrong with it.
struct Followed final : PathListener {
  void motion(ProgrammedBlock const& block) override { places.push_back(block.end[0] / units_per_mm); }
  void command(FilterChange const& /*change*/) override { places.push_back(-1); }
  void end() override { ++ends; }
  std::vector<double> places;
  std::vector<std::string> problems;  ///< "line:column word"
  int ends = 0;
};

Followed follow(std::string const& program, std::uint64_t most_repeated_blocks = 10'000) {
  Followed found;
  ProgramChannel channel;
  channel.axes = {"X", "Y"};
  channel.rotary = {false, false};
  channel.read_filter_command = test::filter_command_reader({});
  channel.most_repeated_blocks = most_repeated_blocks;
  ProgramInterpreter interpreter(channel, found, [&](ProgramProblem const& problem) {
    found.problems.push_back(fmt::format("{}:{} {}", problem.line, problem.span.begin + 1,
                                         problem.line_text.substr(problem.span.begin, problem.span.size())));
  });
  std::istringstream in(program);
  std::uint32_t offset = 0;
  for (std::string line; std::getline(in, line); offset += static_cast<std::uint32_t>(line.size() + 1)) {
    if (!interpreter.line(line, offset)) break;
  }
  interpreter.finish();
  CHECK(found.ends == 1);
  return found;
}

using Places = std::vector<double>;
using Problems = std::vector<std::string>;

Places places(std::string const& program) {
  auto const found = follow("G01 F100\n" + program);
  CHECK(found.problems == Problems{});
  return found.places;
}

}  // namespace

TEST_CASE("parameters are computed") {
  CHECK(places("P1 = 3\nX=P1\nX=P1*2+1\nX[P1-1]\n") == Places{3, 7, 2});
  CHECK(places("V.P.LENGTH = 2 * [1 + 3] / 4 (two)\nX=V.P.LENGTH Y=5\n") == Places{2});
  CHECK(places("P1=-2\nX=-P1\nX=SQRT[16]\nX=ABS[P1]\nX=INT[2.9]\n") == Places{2, 4, 2, 2});
  CHECK(places("X=SIN[30]*10\nX=COS[60]*10\n").at(0) == Approx(5));
  CHECK(places("X=2+3*4-6/2\nX=1-1-1\nX=8/2/2\n") == Places{11, -1, 2});
}

TEST_CASE("a subprogram runs wherever it is called") {
  CHECK(places("%L STEP\nG91 X1\nX2\nM17\n%MAIN\nLL STEP\nN20 LL STEP\nG90 X0\nM30\n") ==
        Places{1, 3, 4, 6, 0});
  // Without M17 it ends with the next one.
  CHECK(places("%L A\nX1\n%L B\nLL A\nX2\nM29\n%MAIN\nLL B\nX3\n") == Places{1, 2, 3});
  // Only %L with a blank begins one.
  CHECK(places("%L A\nX1\nM17\n%LENGTHS\nLL A\nX2\n") == Places{1, 2});
  // One that does not end would hide the program behind it.
  CHECK(follow("%L A\nX1\n").problems == Problems{"1:1 %L A"});
  CHECK(follow("LL NONE\n").problems == Problems{"1:1 LL"});
  CHECK(follow("L OTHER.nc\n").problems == Problems{"1:1 L"});
  // A file may be a subprogram as a whole.
  CHECK(places("X1\nM17\nX2\n") == places("X1\nM30\n"));
  // One mistake gives one message.
  CHECK(follow("X1 LL NONE\n").problems == Problems{"1:1 X1"});
  // What would be lost beside a call.
  CHECK(follow("%L A\nM17\n%MAIN\nG04 X1 LL A\n").problems == Problems{"4:8 LL"});
  CHECK(follow("%L A\nM17\n%L B\nM17 LL A\n%MAIN\nLL B\n").problems == Problems{"4:5 LL"});
  CHECK(follow("%L A\nLL A\nM17\n%MAIN\nLL A\n").problems == Problems{"2:1 LL"});
}

TEST_CASE("loops repeat their blocks") {
  CHECK(places("$FOR P1 = 1, 3\nX=P1\n$ENDFOR\n") == Places{1, 2, 3});
  CHECK(places("$FOR P1 = 10, 0, -5\nX=P1\n$ENDFOR\nX1\n") == Places{10, 5, 0, 1});
  CHECK(places("$FOR P1 = 3, 1\nX=P1\n$ENDFOR\n") == Places{});
  CHECK(places("P1=0\n$WHILE P1 < 3\nP1=P1+1\nX=P1\n$ENDWHILE\n") == Places{1, 2, 3});
  CHECK(places("P1=0\n$REPEAT\nP1=P1+1\nX=P1\n$UNTIL P1 >= 2\n") == Places{1, 2});
  CHECK(places("$FOR P1 = 1, 2\n$FOR P2 = 1, 2\nX=P1*10+P2\n$ENDFOR\n$ENDFOR\n") == Places{11, 12, 21, 22});
  CHECK(places("$FOR P1 = 1, 5\n$IF P1 == 2\n$CONTINUE\n$ENDIF\n$IF P1 == "
               "4\n$BREAK\n$ENDIF\nX=P1\n$ENDFOR\nX9\n") == Places{1, 3, 9});
  CHECK(places("%L A\n$FOR P1 = 1, 5\n$IF P1 == 3\nM17\n$ENDIF\nX=P1\n$ENDFOR\nM17\n%MAIN\nLL A\nX9\n") ==
        Places{1, 2, 9});
  // $BREAK leaves loops, not subprograms.
  CHECK(follow("%L A\n$BREAK\nM17\n%MAIN\nLL A\n").problems == Problems{"2:1 $BREAK"});
  CHECK(follow("%L A\n$CONTINUE\nM17\n%MAIN\n$FOR P1 = 1, 2\nLL A\n$ENDFOR\n").problems ==
        Problems{"2:1 $CONTINUE"});
  CHECK(places("$FOR P1 = 1, 2\n#FILTER OFF\nX=P1\n$ENDFOR\n") == Places{-1, 1, -1, 2});
}

TEST_CASE("conditions choose") {
  std::string const choice =
      "$IF P1 > 5 AND P1 != 7\nX1\n$ELSEIF P1 == 7 OR P1 == 0\nX2\n$ELSE\nX3\n$ENDIF\nX9\n";
  CHECK(places("P1=6\n" + choice) == Places{1, 9});
  CHECK(places("P1=7\n" + choice) == Places{2, 9});
  CHECK(places("P1=1\n" + choice) == Places{3, 9});
  CHECK(places("$IF 0\n$IF 1\nX1\n$ELSE\nX2\n$ENDIF\n$FOR P1 = 1, 2\nX5\n$ENDFOR\n$ELSE\nX3\n$ENDIF\n") ==
        Places{3});
}

TEST_CASE("what cannot be decided or does not end is refused with its place") {
  CHECK(follow("$IF V.P.A\n$ENDIF\n").problems == Problems{"1:1 $IF"});
  CHECK(follow("X=P1\n").problems == Problems{"1:1 X"});
  CHECK(follow("P1=1/0\n").problems == Problems{"1:1 P1"});
  CHECK(follow("P1=V.A.ACT_POS.X\n").problems == Problems{"1:1 P1"});
  CHECK(follow("V.E.X=1\n").problems == Problems{"1:1 V.E.X"});
  CHECK(follow("$GOTO N10\n").problems == Problems{"1:1 $GOTO"});
  CHECK(follow("N10 $ENDFOR\n").problems == Problems{"1:5 $ENDFOR"});
  CHECK(follow("$FOR P1=1,3\n").problems == Problems{"1:1 $FOR"});
  CHECK(follow("$IF 1\n").problems == Problems{"1:1 $IF"});
  CHECK(follow("$FOR P1=1,3\n$ENDWHILE\n").problems == Problems{"1:1 $FOR"});
  CHECK(follow("$WHILE 1\n$ENDWHILE\n").problems == Problems{"1:1 $WHILE"});
  CHECK(follow("$FOR PX=1,3\n$ENDFOR\n").problems == Problems{"1:1 $FOR"});
  CHECK(follow("$FOR P1=1,3\nG54\n$ENDFOR\n").problems == Problems{"2:1 G54"});
  CHECK(follow("P1=" + std::string(100, '[') + "1" + std::string(100, ']') + "\n").problems.size() == 1);
}

}  // namespace axisc::motion::program_flow_test
