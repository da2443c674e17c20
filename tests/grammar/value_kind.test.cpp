// How value tokens are classified.
#include "grammar/axis_list.hpp"
#include "grammar/print_tree.hpp"
#include "support/catch.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace value_kind_test {

namespace {

using axisc::grammar::ValueKind;

/// The kind of a value that stands alone on its line, and that its token is the whole of it.
ValueKind kind_of(std::string_view token) {
  std::string const line = "a " + std::string(token);
  auto const list = axisc::grammar::parse_axis_list(line, 0, true);
  INFO(line);
  REQUIRE(list.problems.empty());
  REQUIRE(list.assignments.size() == 1);
  auto const& assignment = list.assignments.front();
  CHECK(line.substr(assignment.value.begin, assignment.value.size()) == token);
  return assignment.kind;
}

void check_all(ValueKind kind, std::vector<std::string_view> const& tokens) {
  for (std::string_view const token : tokens) {
    INFO(token);
    CHECK(axisc::test::name_of(kind_of(token)) == axisc::test::name_of(kind));
  }
}

TEST_CASE("integers") {
  check_all(ValueKind::integer, {"0", "7", "20", "-5", "+5", "-0", "123456789012345678901234567890"});
}

TEST_CASE("hexadecimal numbers") {
  check_all(ValueKind::hexadecimal, {"0x0", "0x1F", "0X1f", "0x400001", "0x00000001"});
}

TEST_CASE("reals have a point or an exponent") {
  check_all(ValueKind::real, {"1.8", ".5", "1.", "0.5", "-.5", "+1.5", "3.000000e+001", "1e5", "1E-5", "1.e5",
                              ".5e3", "0.", "0e0", "-0.0", "1e99999", "1e007"});
}

TEST_CASE("decimal commas") {
  check_all(ValueKind::decimal_comma, {"1,8", "-1,8", "+0,5", "1,8e3", "1,000", "10,25E-2"});
}

TEST_CASE("malformed numbers begin like numbers") {
  check_all(ValueKind::malformed_number,
            {"12abc", "0x",   "0xG", "1e",    "1e+",   "007",  "00",    "-007",
             "00.5",  "01,8", "1,",  "1,8,3", "1.2.3", "1.5x", "5(x",   "5#x",
             "-0x1F", "+.5x", ".5.", "1,8(c", "1e5.5", "0b1",  "1_000", "5.12.34.56.1.1"});
}

TEST_CASE("words begin with a letter or an underscore") {
  check_all(
      ValueKind::word,
      {"LOWPASS", "TRUE", "X_Achse", "_x", "e5", "x1.5", "lowpass#x", "Lageist/Wert", "a\"b\"",
       "\xC4"
       "chse",
       "P-AXIS-0021", "P-AXIS-002123", "P-AXIS-00212.", "P-AXIS-00212.x", "p-axis-00212", "P-AXIS-00212,0"});
}

TEST_CASE("references name a parameter by five digits") {
  check_all(ValueKind::reference, {"P-AXIS-00212", "P-AXIS-00212.0", "P-AXIS-99999.17"});
}

TEST_CASE("quoted strings keep blanks and parentheses") {
  check_all(ValueKind::quoted, {"\"\"", "\"name\"", "\"name (with bracket)\"", "\"# /* \t\""});
}

TEST_CASE("everything else") {
  check_all(ValueKind::other,
            {"%x", "-", "+", ".", "-x", "=", ",5", "\\path", "/x", "*", "\"a\"b", "\"a b\"c", ")", "[0]"});
}

}  // namespace

}  // namespace value_kind_test
