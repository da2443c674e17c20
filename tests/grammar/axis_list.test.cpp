#include "grammar/axis_list.hpp"

#include "grammar/print_tree.hpp"
#include "support/catch.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace axis_list_test {

namespace {

using namespace axisc::grammar;
using axisc::Span;

std::string tree(std::string_view bytes, bool windows_1252 = false) {
  return axisc::test::print_tree(parse_axis_list(bytes, 0, windows_1252), bytes);
}

TEST_CASE("an empty text has no lines") {
  CHECK(tree("") == "0 lines\n");
  CHECK(tree("\n\r\n \t \n") == "3 lines\n");
}

TEST_CASE("comment lines say nothing") {
  CHECK(tree("# comment\n#\n#comment\n\t # indented\n#[(\"\n") == "5 lines\n");
}

TEST_CASE("an assignment has name, value and trailer") {
  CHECK(tree("filter[0].order 2") == "1: <filter[0].order> = integer <2>\n1 lines\n");
  CHECK(tree("  filter[0].order\t \t2\t( P-AXIS-00140 ") ==
        "1: <filter[0].order> = integer <2>, parenthesis <( P-AXIS-00140>\n1 lines\n");
  CHECK(tree("a 5 # x") == "1: <a> = integer <5>, hash <# x>, as text <5 # x>\n1 lines\n");
  CHECK(tree("a 5 /*x") == "1: <a> = integer <5>, slash-star </*x>, as text <5 /*x>\n1 lines\n");
  CHECK(tree("a 1 5") == "1: <a> = integer <1>, text <5>, as text <1 5>\n1 lines\n");
  CHECK(tree("a 1 / 5") == "1: <a> = integer <1>, text </ 5>, as text <1 / 5>\n1 lines\n");
}

TEST_CASE("spans count bytes from the start of the text") {
  std::string_view const bytes = "\n a.b  20 ( c \r\n";
  auto const list = parse_axis_list(bytes, 0, false);
  REQUIRE(list.assignments.size() == 1);
  auto const& assignment = list.assignments.front();
  CHECK(assignment.name == Span{2, 5});
  CHECK(assignment.value == Span{7, 9});
  CHECK(assignment.trailer == Span{10, 13});
  CHECK(free_text(bytes, assignment) == Span{7, 9});
  CHECK(assignment.line == 2);
}

TEST_CASE("an empty trailer is a place behind the value") {
  auto const list = parse_axis_list("a 20", 0, false);
  CHECK(list.assignments.at(0).trailer == Span{4, 4});
}

TEST_CASE("text in front of the list is skipped") {
  std::string_view const bytes =
      "\xEF\xBB\xBF"
      "a 1\n1\n";
  auto const list = parse_axis_list(bytes, 3, false);
  REQUIRE(list.assignments.size() == 1);
  CHECK(list.assignments[0].name == Span{3, 4});
  CHECK(list.assignments[0].line == 1);
  REQUIRE(list.problems.size() == 1);
  CHECK(list.problems[0].span == Span{7, 8});
  CHECK(list.problems[0].line == 2);
}

TEST_CASE("words and strings end at a parenthesis, and free text goes on to it") {
  CHECK(tree("a LOWPASS(c") == "1: <a> = word <LOWPASS>, parenthesis <(c>\n1 lines\n");
  CHECK(tree("a X Achse (c") == "1: <a> = word <X>, text <Achse (c>, as text <X Achse>\n1 lines\n");
  CHECK(tree("a LOWPASS # low") ==
        "1: <a> = word <LOWPASS>, hash <# low>, as text <LOWPASS # low>\n1 lines\n");
  CHECK(tree("a \"n (b)\"(c") == "1: <a> = quoted <\"n (b)\">, parenthesis <(c>\n1 lines\n");
  CHECK(tree("a \"n\" x (c") == "1: <a> = quoted <\"n\">, text <x (c>, as text <\"n\" x>\n1 lines\n");
  CHECK(tree("a b \"(\" (c") == "1: <a> = word <b>, text <\"(\" (c>, as text <b \"(\">\n1 lines\n");
  CHECK(tree("a b 5\" (c") == "1: <a> = word <b>, text <5\" (c>, as text <b 5\">\n1 lines\n");
  CHECK(tree("a P-AXIS-00212(c") == "1: <a> = reference <P-AXIS-00212>, parenthesis <(c>\n1 lines\n");
  CHECK(tree("a %x(c d") == "1: <a> = other <%x(c>, text <d>, as text <%x>\n1 lines\n");
}

TEST_CASE("letters above 0x7F are letters of words, never of names") {
  CHECK(tree("kopf.log_achs_name \xC4"
             "chse (\xFC",
             true) == "1: <kopf.log_achs_name> = word <\\xC4chse>, parenthesis <(\\xFC>\n1 lines\n");
  CHECK(tree("gr\xF6\xDF"
             "e 5",
             true) == "1: ! expected-name <gr\\xF6\\xDFe>\n1 lines\n");
}

TEST_CASE("a line that begins with no name") {
  CHECK(tree("5 a") == "1: ! expected-name <5>\n1 lines\n");
  CHECK(tree("  -x.y[1] 7") == "1: ! expected-name <-x.y[1]>\n1 lines\n");
  CHECK(tree("(comment) a 5") == "1: ! expected-name <(comment)>\n1 lines\n");
  CHECK(tree("/* a */") == "1: ! expected-name </*>\n1 lines\n");
  CHECK(tree("a..b 5") == "1: ! expected-name <a..b>\n1 lines\n");
  CHECK(tree("a. 5") == "1: ! expected-name <a.>\n1 lines\n");
  CHECK(tree("a=5") == "1: ! expected-name <a=5>\n1 lines\n");
  CHECK(tree("a[0]b 5") == "1: ! expected-name <a[0]b>\n1 lines\n");
  CHECK(tree("a] 5") == "1: ! expected-name <a]>\n1 lines\n");
  CHECK(tree("filter-fir.order 5") == "1: ! expected-name <filter-fir.order>\n1 lines\n");
}

TEST_CASE("a name without value") {
  CHECK(tree("filter[0].order") == "1: ! expected-value <filter[0].order>\n1 lines\n");
  CHECK(tree(" a.b  \t") == "1: ! expected-value <a.b>\n1 lines\n");
  CHECK(tree("a ( 5") == "1: ! expected-value <a>\n1 lines\n");
  CHECK(tree("a # 5") == "1: ! expected-value <a>\n1 lines\n");
  CHECK(tree("a /* 5") == "1: ! expected-value <a>\n1 lines\n");
}

TEST_CASE("a broken index is shown from its bracket to its end") {
  CHECK(tree("filter[.order 2") == "1: ! malformed-index <[>\n1 lines\n");
  CHECK(tree("filter[].order 2") == "1: ! malformed-index <[]>\n1 lines\n");
  CHECK(tree("filter[0.order 2") == "1: ! malformed-index <[0>\n1 lines\n");
  CHECK(tree("filter[0 .order 2") == "1: ! malformed-index <[0>\n1 lines\n");
  CHECK(tree("filter[-1].order 2") == "1: ! malformed-index <[-1]>\n1 lines\n");
  CHECK(tree("filter[ 0 ].order 2") == "1: ! malformed-index <[ 0 ]>\n1 lines\n");
  CHECK(tree("filter[i].order 2") == "1: ! malformed-index <[i]>\n1 lines\n");
  CHECK(tree("filter[0][1].order 2") == "1: ! malformed-index <[0][1]>\n1 lines\n");
  CHECK(tree("a[0].b[ 2") == "1: ! malformed-index <[>\n1 lines\n");
}

TEST_CASE("a string that is not closed is shown to the end of its line") {
  CHECK(tree("a \"n (c \n") == "1: ! unterminated-string <\"n (c>\n1 lines\n");
  CHECK(tree("a \"") == "1: ! unterminated-string <\">\n1 lines\n");
}

TEST_CASE("a line with an invalid character contributes nothing else") {
  using namespace std::string_view_literals;
  CHECK(tree("a 1\0\1\nb 2\n"sv) == "1: ! invalid-character <\\x00>\n2: <b> = integer <2>\n2 lines\n");
  CHECK(tree("# \x1B\n") == "1: ! invalid-character <\\x1B>\n1 lines\n");
  CHECK(tree("a 1\rb 2\r\n") == "1: ! invalid-character <\\x0D>\n1 lines\n");
  CHECK(tree("\x01 a[") == "1: ! invalid-character <\\x01>\n1 lines\n");
  CHECK(tree("a 1 (\x81\n", true) == "1: ! invalid-character <\\x81>\n1 lines\n");
  CHECK(tree("a 1 (\xC2\x85\n") == "1: ! invalid-character <\\xC2\\x85>\n1 lines\n");
  CHECK(tree("a 1 (\xC2\x85\n", true) == "1: <a> = integer <1>, parenthesis <(\\xC2\\x85>\n1 lines\n");
}

TEST_CASE("the list ends with a word") {
  CHECK(tree("Ende") == "   end <Ende>\n1 lines\n");
  CHECK(tree("\t ENDE \r\n\n# comment\n") == "   end <ENDE>\n3 lines\n");
  CHECK(tree("ende # x") == "   end <ende>\n1 lines\n");
  CHECK(tree("Ende (x") == "   end <Ende>\n1 lines\n");
  CHECK(tree("Ende.x 5") == "1: <Ende.x> = integer <5>\n1 lines\n");
  CHECK(tree("Endes 5") == "1: <Endes> = integer <5>\n1 lines\n");
}

TEST_CASE("text behind the end is reported once and not read") {
  CHECK(tree("Ende 5\na[ 1\n") == "   end <Ende>\n1: ! text-after-end <5>\n2 lines\n");
  CHECK(tree("Ende\n\n a 5 (c \nEnde\n") == "   end <Ende>\n3: ! text-after-end <a 5 (c>\n4 lines\n");
  CHECK(tree("Ende\n\x1A") == "   end <Ende>\n2: ! text-after-end <\\x1A>\n2 lines\n");
  CHECK(tree("Ende \x01") == "   end <Ende>\n1: ! invalid-character <\\x01>\n1 lines\n");
}

TEST_CASE("comments that speak to the program are kept") {
  CHECK(tree("# axisc: allow AX3005\n") ==
        "1: directive for the next line <# axisc: allow AX3005>\n1 lines\n");
  CHECK(tree("a 1 (axisc: allow AX2005") ==
        "1: <a> = integer <1>, parenthesis <(axisc: allow AX2005>\n1: directive <(axisc: allow AX2005>\n1 "
        "lines\n");
  CHECK(tree("a[ 1 (axisc: allow AX1004") ==
        "1: ! malformed-index <[>\n1: directive <(axisc: allow AX1004>\n1 lines\n");
  CHECK(tree("Ende (axisc: x") == "   end <Ende>\n1: directive <(axisc: x>\n1 lines\n");
  CHECK(tree("a axisc:x") == "1: <a> = word <axisc:x>\n1 lines\n");
  CHECK(tree("a 1 (Axisc: x\n# axisc :\n# isc:") ==
        "1: <a> = integer <1>, parenthesis <(Axisc: x>\n3 lines\n");
}

TEST_CASE("the first and the last line may be bad, with and without line end") {
  CHECK(tree("1\na 2\n") == "1: ! expected-name <1>\n2: <a> = integer <2>\n2 lines\n");
  CHECK(tree("a 2\n1\n") == "1: <a> = integer <2>\n2: ! expected-name <1>\n2 lines\n");
  CHECK(tree("a 2\n1") == "1: <a> = integer <2>\n2: ! expected-name <1>\n2 lines\n");
  CHECK(tree("a 2\nb 3") == "1: <a> = integer <2>\n2: <b> = integer <3>\n2 lines\n");
}

TEST_CASE("every bad line is reported, however many there are") {
  std::string bytes;
  constexpr std::size_t count = 20000;
  for (std::size_t i = 0; i < count; ++i) bytes += i % 2 == 0 ? "filter[.order 2 (comment\n" : "\t1 x\r\n";
  auto const list = parse_axis_list(bytes, 0, false);
  CHECK(list.assignments.empty());
  REQUIRE(list.problems.size() == count);
  for (std::size_t i = 0; i < count; ++i) {
    REQUIRE(list.problems[i].line == i + 1);
    REQUIRE(list.problems[i].kind ==
            (i % 2 == 0 ? ProblemKind::malformed_index : ProblemKind::expected_name));
  }
}

TEST_CASE("the longest lines are read in one go") {
  std::string const long_name = "a" + std::string(longest_line - 3, 'b') + " 1";
  CHECK(parse_axis_list(long_name, 0, false).assignments.size() == 1);
  std::string const dots = [] {
    std::string text;
    while (text.size() < longest_line - 10) text += "a[0].";
    return text + "b 1";
  }();
  CHECK(parse_axis_list(dots, 0, false).assignments.size() == 1);
  CHECK(parse_axis_list("a 1 " + std::string(longest_line - 10, '"'), 0, false).assignments.size() == 1);
  CHECK(parse_axis_list("a" + std::string(longest_line - 10, '['), 0, false).problems.size() == 1);
  CHECK(parse_axis_list("a 1" + std::string(longest_line - 10, '0'), 0, false).assignments.size() == 1);
  CHECK(parse_axis_list(std::string(longest_line, ':'), 0, false).problems.size() == 1);
}

}  // namespace

}  // namespace axis_list_test
