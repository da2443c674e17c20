#include "diagnostics/writers/writers.hpp"
#include "report_example.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc;
using namespace axisc::test;

TEST_CASE("SARIF form") {
  ReportExample const example;
  std::string const text = write_sarif(example.findings, example.full.sources, example.context, {});
  check_golden("tests/diagnostics/data/sarif/findings.en.sarif", text);
  CHECK(sarif_complaints(text) == std::vector<std::string>{});
  CHECK(nlohmann::ordered_json::parse(text).dump(2) + "\n" == text);
}

TEST_CASE("SARIF form without findings") {
  CHECK(sarif_complaints(write_sarif({}, {}, {.rules = {}, .version = "1.2.3", .paths = {}, .failures = {}},
                                     {})) == std::vector<std::string>{});
}

TEST_CASE("the test of the SARIF structure finds mistakes") {
  ReportExample const example;
  std::string const text = write_sarif(example.findings, example.full.sources, example.context, {});
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
  auto const run = nlohmann::json::parse(
      write_sarif(example.findings, example.full.sources, example.context, {}))["runs"][0];
  auto const& rules = run["tool"]["driver"]["rules"];
  CHECK(rules.size() == 2);
  for (auto const& result : run["results"]) {
    CHECK(rules[result["ruleIndex"].get<std::size_t>()]["id"] == result["ruleId"]);
  }
}
