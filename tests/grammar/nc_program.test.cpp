// How the lines of an NC program are read.
#include "grammar/nc_program.hpp"

#include "grammar/program_trace.hpp"
#include "support/catch.hpp"

#include <string>
#include <string_view>

namespace nc_program_test {

namespace {

using axisc::Span;
using axisc::grammar::parse_nc_program;
using axisc::grammar::ProgramDetail;
using axisc::test::trace_program;

std::string words(std::string_view bytes) {
  return trace_program(bytes, ProgramDetail::words);
}

std::string commands(std::string_view bytes) {
  return trace_program(bytes, ProgramDetail::commands);
}

TEST_CASE("the words of a block") {
  CHECK(words("N010 G00 G90X0 Y-1.5Z.5 F4000\n") ==
        "1: block-number <N010>\n1: address <G00>\n1: address <G90>\n1: address <X0>\n1: address <Y-1.5>\n"
        "1: address <Z.5>\n1: address <F4000>\n");
  CHECK(words("/N20 M30") == "1: skip </>\n1: block-number <N20>\n1: address <M30>\n");
  CHECK(words("/3 M30") == "1: skip </3>\n1: address <M30>\n");
  CHECK(words("G01 N20") == "1: address <G01>\n1: address <N20>\n");
}

TEST_CASE("expressions and variables fall into words") {
  CHECK(words("X1=5 P1=V.P.A[3]*2") ==
        "1: name <X1>\n1: other <=>\n1: number <5>\n1: name <P1>\n1: other <=>\n1: name <V.P.A>\n"
        "1: other <[>\n1: number <3>\n1: other <]>\n1: other <*>\n1: number <2>\n");
  CHECK(words("$IF P1 > 2") == "1: control <$IF>\n1: address <P1>\n1: other <>>\n1: number <2>\n");
}

TEST_CASE("programs and calls of subprograms") {
  CHECK(
      words("%L UP1 (contour)\nM17\n%MAIN\nLL UP1\nL \"part.nc\"\n") ==
      "1: program <%L UP1>\n2: address <M17>\n3: program <%MAIN>\n4: name <LL>\n4: name <UP1>\n5: name <L>\n"
      "5: text <\"part.nc\">\n");
}

TEST_CASE("comments are no words") {
  CHECK(words("N500 X10 (in a block) Y20\n(a (nested) one)\n;to the end (\n(not closed\nG01(not #closed\n") ==
        "1: block-number <N500>\n1: address <X10>\n1: address <Y20>\n5: address <G01>\n");
}

TEST_CASE("a string is one word, whatever it holds") {
  CHECK(words("#MSG [\"a (b) ; #FILTER ON\" X\n\"open ; #FILTER\nX1") ==
        "1: other <#MSG>\n1: other <[>\n1: text <\"a (b) ; #FILTER ON\">\n1: name <X>\n"
        "2: text <\"open ; #FILTER>\n3: address <X1>\n");
}

TEST_CASE("commands stand behind block numbers, other words and other commands") {
  CHECK(commands("N30 #FILTER ON [AX_DEV=0.001]\n/N40 X5 #FILTER OFF\n#SLOPE [TYPE=TRAPEZ]#FILTER\n") ==
        "1: filter <#FILTER> on <AX_DEV>=real <0.001>\n2: filter <#FILTER> off\n3: other <#SLOPE>\n"
        "3: filter <#FILTER>\n");
  CHECK(commands("#FILTER ON X5 #VIB GUARD ON\n") ==
        "1: filter <#FILTER> on ! unexpected-text <X5>\n1: vibration-guard <#VIB GUARD> on\n");
}

TEST_CASE("a command inside a comment is no command") {
  CHECK(commands("(#FILTER ON)\n; #FILTER ON\nX5 (#FILTER ON\n(a)#FILTER OFF(#VIB GUARD)\n") ==
        "4: filter <#FILTER> off\n");
}

TEST_CASE("a comment over several lines") {
  CHECK(
      commands("#FILTER ON\nN10 #COMMENT BEGIN\n#FILTER OFF\n#COMMENT BEGIN\n(#COMMENT END)\nX #COMMENT END\n"
               "N20 #COMMENT END\n#FILTER [ORDER=2]\n") ==
      "1: filter <#FILTER> on\n8: filter <#FILTER> <ORDER>=integer <2>\n");
  CHECK(commands("#COMMENT BEGIN\n#FILTER ON") == "");
}

TEST_CASE("a backslash lets a block go on") {
  CHECK(commands(
            "X1\nN10 #FILTER ON [ORDER=20 \\\n  SHARE=80 \\ \r\n\n ;comment \\\n  FCUT=50]\n#FILTER OFF") ==
        "2: filter <#FILTER> on <ORDER>=integer <20> <SHARE>=integer <80> <FCUT>=integer <50>\n"
        "7: filter <#FILTER> off\n");
  CHECK(commands("#FILTER ON (comment \\\n#FILTER OFF") ==
        "1: filter <#FILTER> on\n2: filter <#FILTER> off\n");
  CHECK(commands("G01 \\\n X5 \\\n #FILTER ON \\") == "3: filter <#FILTER> on\n");
  CHECK(words("G01 \\\n X5\nN1 \"a\\\"\\\nY2") ==
        "1: address <G01>\n2: address <X5>\n3: block-number <N1>\n3: text <\"a\\\">\n4: address <Y2>\n");
}

TEST_CASE("comments that speak to this program") {
  CHECK(commands("#FILTER ON (axisc: allow AX5006)\nN10 ;axisc: allow AX5007\nX1 \"(axisc: no)\"\n") ==
        "1: directive <(axisc: allow AX5006)>\n1: filter <#FILTER> on\n"
        "2: directive alone <;axisc: allow AX5007>\n");
}

TEST_CASE("a program keeps its commands and directives, with places") {
  std::string_view const bytes =
      "\xEF\xBB\xBFN10 G01\r\n#SLOPE\r\nN20 #FILTER ON [ORDER=20] (axisc: allow AX5006)\r\n#PUT AX ALL";
  auto const program = parse_nc_program(bytes, 3);
  CHECK(program.lines == 4);
  REQUIRE(program.commands.size() == 2);
  auto const& command = program.commands[0];
  CHECK(command.name == Span{24, 31});
  REQUIRE(command.keywords.size() == 1);
  CHECK(command.keywords[0].name == Span{36, 41});
  CHECK(command.keywords[0].value == Span{42, 44});
  CHECK(command.line == 3);
  CHECK(program.commands[1].line == 4);
  REQUIRE(program.directives.size() == 1);
  CHECK(program.directives[0].line == 3);
}

TEST_CASE("bad lines hide no others") {
  CHECK(
      commands("#FILTER ON [ORDER=\n#FILTER ON [\n]]]]\n#\n# FILTER\n\"\n\\\n#FILTER OFF") ==
      "1: filter <#FILTER> on <ORDER>=missing <> ! unclosed-bracket <[>\n"
      "2: filter <#FILTER> on ! unclosed-bracket <[>\n4: other <#>\n5: other <#>\n8: filter <#FILTER> off\n");
}

}  // namespace

}  // namespace nc_program_test
