#include "report_example.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"

#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc;
using namespace axisc::test;

TEST_CASE("SARIF form") {
  ReportExample const example;
  std::string const text = example.report(FindingFormat::sarif);
  check_golden("tests/diagnostics/data/sarif/findings.en.sarif", text);
  CHECK(sarif_complaints(text) == std::vector<std::string>{});
  CHECK(nlohmann::ordered_json::parse(text).dump(2) + "\n" == text);
}

TEST_CASE("SARIF form without findings") {
  auto const text =
      whole_report(FindingFormat::sarif, {}, {}, {}, {.rules = {}, .version = "1.2.3", .paths = {}});
  CHECK(sarif_complaints(text) == std::vector<std::string>{});
}

TEST_CASE("the test of the SARIF structure finds mistakes") {
  ReportExample const example;
  std::string const text = example.report(FindingFormat::sarif);
  auto const broken = [&](auto change) {
    auto document = nlohmann::json::parse(text);
    change(document);
    return !sarif_complaints(document.dump()).empty();
  };
  CHECK(broken([](nlohmann::json& document) { document["version"] = "2.0.0"; }));
  CHECK(broken([](nlohmann::json& document) { document["runs"][0].erase("tool"); }));
  CHECK(broken([](nlohmann::json& document) { document["runs"][0]["results"][0]["level"] = "fatal"; }));
  CHECK(broken([](nlohmann::json& document) { document["runs"][0]["results"][0]["colour"] = "red"; }));
  CHECK(broken([](nlohmann::json& document) { document["runs"][0]["results"][0]["message"]["text"] = ""; }));
}

TEST_CASE("results point at their rules") {
  ReportExample const example;
  auto const run = nlohmann::json::parse(example.report(FindingFormat::sarif))["runs"][0];
  auto const& rules = run["tool"]["driver"]["rules"];
  CHECK(rules.size() == 2);
  for (auto const& result : run["results"]) {
    CHECK(rules[result["ruleIndex"].get<std::size_t>()]["id"] == result["ruleId"]);
  }
}

TEST_CASE("what concerns the whole run is a notification of SARIF, not a result") {
  ReportExample const example;
  auto const& note = example.findings.front();
  auto const writer = report_writer(FindingFormat::sarif, {}, example.context);
  std::string text;
  writer->begin(text);
  writer->add_notice(text, note, example.full.sources, {});
  writer->end_input(example.full.sources);
  writer->end([&text](std::string_view piece) { text += piece; }, {});
  CHECK(sarif_complaints(text) == std::vector<std::string>{});
  auto const run = nlohmann::json::parse(text)["runs"][0];
  CHECK(run["results"].empty());
  auto const& notices = run["invocations"][0]["toolExecutionNotifications"];
  REQUIRE(notices.size() == 1);
  CHECK(notices[0]["level"] == "note");
  CHECK(notices[0]["message"]["text"] == whole_message(note, Language::english));
  CHECK(notices[0]["associatedRule"]["id"] == "AX9006");
}

TEST_CASE("a list that several inputs share is one artifact of SARIF") {
  ReportExample const example;
  auto const writer = report_writer(FindingFormat::sarif, {}, example.context);
  std::string text;
  writer->begin(text);
  for (int input = 0; input < 2; ++input) {
    writer->add(text, example.full.finding, example.full.sources, "1:1");
    writer->end_input(example.full.sources);
  }
  writer->end([&text](std::string_view piece) { text += piece; }, {});
  auto const run = nlohmann::json::parse(text)["runs"][0];
  CHECK(run["results"].size() == 2);
  std::set<std::string> names;
  for (auto const& artifact : run["artifacts"]) {
    CHECK(names.insert(artifact["location"]["uri"].get<std::string>()).second);
  }
  CHECK_FALSE(names.empty());
}
