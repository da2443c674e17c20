#include "report_example.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"

#include <set>
#include <string>

#include <nlohmann/json.hpp>

using namespace axisc;
using namespace axisc::test;

TEST_CASE("code quality report of GitLab") {
  ReportExample const example;
  std::string const text = example.report(FindingFormat::gitlab);
  check_golden("tests/diagnostics/data/gitlab/findings.en.json", text);
  auto const report = nlohmann::json::parse(text);
  REQUIRE(report.size() == example.findings.size());
  std::set<std::string> const severities{"info", "minor", "major", "critical", "blocker"};
  std::set<std::string> fingerprints;
  for (auto const& entry : report) {
    CHECK(severities.contains(entry["severity"].get<std::string>()));
    CHECK(entry["location"]["lines"]["begin"].get<int>() >= 1);
    CHECK(fingerprints.insert(entry["fingerprint"].get<std::string>()).second);
  }
}

TEST_CASE("an empty code quality report is an empty list") {
  CHECK(whole_report(FindingFormat::gitlab, {}, {}) == "[]\n");
}
