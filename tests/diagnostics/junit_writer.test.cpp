#include "report_example.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <string>

using namespace axisc;
using namespace axisc::test;

TEST_CASE("JUnit report") {
  ReportExample const example;
  std::string const text = example.report(FindingFormat::junit);
  check_golden("tests/diagnostics/data/junit/findings.en.xml", text);
  pugi::xml_document document;
  REQUIRE(document.load_string(text.c_str()));
  auto const suites = document.child("testsuites");
  auto const cases = suites.child("testsuite").children("testcase");
  auto const count = [&](char const* child) {
    return std::count_if(cases.begin(), cases.end(),
                         [child](pugi::xml_node const& one) { return static_cast<bool>(one.child(child)); });
  };
  CHECK(count("failure") == static_cast<std::ptrdiff_t>(example.findings.size()));
  CHECK(count("error") == 1);
  CHECK(suites.attribute("failures").as_llong() == count("failure"));
  CHECK(suites.attribute("errors").as_llong() == 1);
  CHECK(suites.attribute("tests").as_llong() == std::distance(cases.begin(), cases.end()));
  // The whole message arrives, whatever characters it has.
  auto const expected = "1 ms, 100 %: assumed";
  CHECK(cases.begin()->next_sibling().child("failure").attribute("message").as_string() ==
        std::string(expected));
}

TEST_CASE("a JUnit report without findings has a test that passed") {
  pugi::xml_document document;
  REQUIRE(document.load_string(whole_report(FindingFormat::junit, {}, {}).c_str()));
  CHECK(document.child("testsuites").attribute("tests").as_int() == 1);
  CHECK_FALSE(document.child("testsuites").child("testsuite").child("testcase").first_child());
}
