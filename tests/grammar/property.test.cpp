// What holds for every list: the grammar agrees with a plain scanner, spans lie inside the text, and no line
// knows of another one.
#include "grammar/axis_list.hpp"
#include "grammar/plain_scanner.hpp"
#include "grammar/print_tree.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <rapidcheck.h>

namespace property_test {

namespace {

using axisc::Span;
using axisc::grammar::AxisList;
using axisc::grammar::parse_axis_list;
using axisc::test::print_tree;
using axisc::test::scan_axis_list;

/// Pieces of lists that the language tells apart, and some that it should not.
rc::Gen<std::string> piece() {
  return rc::gen::element<std::string>(
      "filter", "order", "lr_param", "Ende", "ENDE", "end", "x", "_", "P-AXIS-00212", "P-AXIS-0021",
      "P-AXIS-00212.0", "LOWPASS", "TRUE", "e", "E", "[", "]", "[0]", "[12]", "[-1]", "[ 0 ]", "0", "1", "7",
      "00", "20", "0x1F", "0x", ".", ",", "1.5", "1,8", "1e5", "e+3", "-", "+", "#", "(", ")", "/*", "/",
      "\"", " ", " ", " ", "\t", "  ", "\n", "\n", "\r\n", "\r", "\xE4", "\xC3\xA4", "\xC2\x85", "\x81",
      std::string(1, '\0'), "\x1A", "\x7F", "axisc:", "axisc: allow AX3005", ":", "%x", "C:\\path", "=", ";");
}

rc::Gen<std::string> list_text() {
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece()),
                      [](std::vector<std::string> const& pieces) {
                        std::string text;
                        for (std::string const& part : pieces) text += part;
                        return text;
                      });
}

/// Lines that are mostly right.
rc::Gen<std::string> likely_list() {
  auto const line = rc::gen::map(
      rc::gen::tuple(rc::gen::element<std::string>("filter[0].order", " a.b", "x[1].y[2]", "Kopf.nr", "a[",
                                                   "1a", "#", "Ende"),
                     rc::gen::element<std::string>(" ", "\t ", ""), piece(), piece(), piece(),
                     rc::gen::element<std::string>("\n", "\r\n", " \n")),
      [](auto const& parts) {
        return std::apply([](auto const&... part) { return (std::string() + ... + part); }, parts);
      });
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(line),
                      [](std::vector<std::string> const& lines) {
                        std::string text;
                        for (std::string const& one : lines) text += one;
                        return text;
                      });
}

bool inside(Span span, std::string_view bytes) {
  return span.begin <= span.end && span.end <= bytes.size();
}

void check_spans(AxisList const& list, std::string_view bytes) {
  for (auto const& assignment : list.assignments) {
    RC_ASSERT(inside(assignment.name, bytes));
    RC_ASSERT(!assignment.name.empty());
    RC_ASSERT(inside(assignment.value, bytes));
    RC_ASSERT(!assignment.value.empty());
    RC_ASSERT(assignment.name.end < assignment.value.begin);
    RC_ASSERT(inside(assignment.trailer, bytes));
    RC_ASSERT(assignment.value.end <= assignment.trailer.begin);
    Span const free_text = axisc::grammar::free_text(bytes, assignment);
    RC_ASSERT(inside(free_text, bytes));
    RC_ASSERT(free_text.begin == assignment.value.begin);
    RC_ASSERT(assignment.line >= 1U);
    RC_ASSERT(assignment.line <= list.lines);
  }
  for (auto const& problem : list.problems) {
    RC_ASSERT(inside(problem.span, bytes));
    RC_ASSERT(!problem.span.empty());
  }
  for (auto const& directive : list.directives) RC_ASSERT(inside(directive.comment, bytes));
}

void check_against_scanner(std::string const& bytes, bool windows_1252) {
  AxisList const list = parse_axis_list(bytes, 0, windows_1252);
  check_spans(list, bytes);
  RC_ASSERT(print_tree(list, bytes) == print_tree(scan_axis_list(bytes, windows_1252), bytes));
}

TEST_CASE("the grammar agrees with a scanner by hand") {
  REQUIRE(rc::check("pieces in any order",
                    [] { check_against_scanner(*list_text(), *rc::gen::arbitrary<bool>()); }));
  REQUIRE(rc::check("lines that are mostly right",
                    [] { check_against_scanner(*likely_list(), *rc::gen::arbitrary<bool>()); }));
  REQUIRE(rc::check("any bytes", [](std::string const& bytes) { check_against_scanner(bytes, true); }));
}

TEST_CASE("a file reads like its lines one by one") {
  REQUIRE(rc::check("lines are independent", [] {
    std::string const bytes = *likely_list();
    AxisList const whole = parse_axis_list(bytes, 0, true);
    std::size_t assignments = 0;
    std::size_t problems = 0;
    std::size_t begin = 0;
    bool ended = false;
    while (begin < bytes.size() && !ended) {
      std::size_t const end = std::min(bytes.find('\n', begin), bytes.size() - 1) + 1;
      std::string const line = bytes.substr(begin, end - begin);
      AxisList const single = parse_axis_list(line, 0, true);
      auto const offset = static_cast<std::uint32_t>(begin);
      for (auto const& assignment : single.assignments) {
        RC_ASSERT(assignments < whole.assignments.size());
        RC_ASSERT(whole.assignments[assignments].value.begin == assignment.value.begin + offset);
        RC_ASSERT(whole.assignments[assignments].kind == assignment.kind);
        ++assignments;
      }
      for (auto const& problem : single.problems) {
        RC_ASSERT(problems < whole.problems.size());
        RC_ASSERT(whole.problems[problems].kind == problem.kind);
        RC_ASSERT(whole.problems[problems].span.begin == problem.span.begin + offset);
        ++problems;
      }
      ended = single.end_marker.has_value();
      begin = end;
    }
    RC_ASSERT(assignments == whole.assignments.size());
    RC_ASSERT(ended || problems == whole.problems.size());
  }));
}

TEST_CASE("line ends do not matter") {
  REQUIRE(rc::check("LF and CR LF give the same tree", [] {
    std::string unix_text = *likely_list();
    unix_text.erase(std::remove(unix_text.begin(), unix_text.end(), '\r'), unix_text.end());
    std::string windows_text;
    for (char const byte : unix_text) {
      if (byte == '\n') windows_text += '\r';
      windows_text += byte;
    }
    RC_ASSERT(print_tree(parse_axis_list(unix_text, 0, true), unix_text) ==
              print_tree(parse_axis_list(windows_text, 0, true), windows_text));
  }));
}

}  // namespace

}  // namespace property_test
