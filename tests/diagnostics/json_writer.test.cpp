#include "example_findings.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "whole_report.hpp"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc;
using namespace axisc::test;

namespace {

constexpr Sentence summary_nothing{"no findings", "keine Befunde"};

std::vector<std::string> keys_of(nlohmann::ordered_json const& object) {
  std::vector<std::string> keys;
  for (auto const& item : object.items()) keys.push_back(item.key());
  return keys;
}

}  // namespace

TEST_CASE("JSON form of findings with and without everything") {
  FullExample example;
  std::vector<Finding> findings{example.finding,
                                error_at(place_of(example.sources, example.list, "LOWPASS"), "bare")};
  Finding without_place;
  without_place.code = Code{9001};
  without_place.name = "cannot-read";
  without_place.file = "missing.lis";
  without_place.message = say("the file cannot be read");
  findings.insert(findings.begin(), without_place);
  check_golden("tests/diagnostics/data/json/findings.en.json",
               write_json(findings, example.sources, {.files = 2}, {.language = Language::english}));
}

TEST_CASE("JSON form without findings") {
  CHECK(write_json({}, SourceSet{}, {.files = 1}, {}) ==
        "{\n  \"version\": 1,\n  \"diagnostics\": [],\n  \"summary\": {\n    \"files\": 1,\n    \"errors\": "
        "0,\n"
        "    \"warnings\": 0,\n    \"notes\": 0\n  }\n}\n");
}

TEST_CASE("the fields of the JSON form") {
  FullExample const example;
  auto const json = nlohmann::ordered_json::parse(
      write_json({example.finding}, example.sources, {.files = 1}, {.language = Language::german}));
  CHECK(keys_of(json) == std::vector<std::string>{"version", "diagnostics", "summary"});
  auto const& finding = json["diagnostics"][0];
  CHECK(keys_of(finding) == std::vector<std::string>{"code", "name", "severity", "message", "file", "line",
                                                     "column", "end_line", "end_column", "parameter",
                                                     "p_axis", "axis", "control", "notes", "related", "fix"});
  CHECK(keys_of(finding["control"]) == std::vector<std::string>{"message", "reaction", "value"});
  CHECK(keys_of(finding["related"][0]) == std::vector<std::string>{"file", "line", "column", "message"});
  CHECK(keys_of(finding["fix"]) == std::vector<std::string>{"title", "edits"});
  CHECK(keys_of(finding["fix"]["edits"][0]) ==
        std::vector<std::string>{"file", "line", "column", "end_line", "end_column", "text"});
  CHECK(keys_of(json["summary"]) == std::vector<std::string>{"files", "errors", "warnings", "notes"});
  CHECK(finding["line"] == 2);
  CHECK(finding["column"] == 19);
  CHECK(finding["end_column"] == 22);
}

TEST_CASE("messages of the JSON form follow the language") {
  DelayExample example;
  example.finding.message = {summary_nothing};
  auto const message = [&](Language language) {
    auto const json = nlohmann::json::parse(
        write_json({example.finding}, example.sources, {.files = 1}, {.language = language}));
    CHECK(json["diagnostics"][0]["severity"] == "error");
    return json["diagnostics"][0]["message"].get<std::string>();
  };
  CHECK(message(Language::english) == "no findings");
  CHECK(message(Language::german) == "keine Befunde");
}

TEST_CASE("the JSON form is well-formed whatever the strings hold") {
  SourceSet sources;
  SourceId const id = sources.add(SourceText("G\xFCte\n.lis", "a \xFC\x01\n"));
  Finding finding = error_at(place_of(sources, id, "\xFC"), "bad \xFF \"quoted\"\n{\x01}");
  finding.parameter = "x\xC0";
  finding.label = say("label");
  finding.help = {say("help")};
  auto const json = nlohmann::json::parse(write_json({finding, finding}, sources, {.files = 1}, {}));
  REQUIRE(json["diagnostics"].size() == 2);
  auto const& first = json["diagnostics"][0];
  CHECK(first["message"] == "bad \xEF\xBF\xBD \"quoted\"\n{\x01}");
  CHECK(first["file"] == "G\xEF\xBF\xBDte\n.lis");
  CHECK(first["parameter"] == "x\xEF\xBF\xBD");
  CHECK(first["notes"] == nlohmann::json({"label", "help"}));
  CHECK(first == json["diagnostics"][1]);
}

TEST_CASE("the JSON form has the layout of the library's own indentation") {
  FullExample const example;
  std::string const text = write_json({example.finding, example.finding}, example.sources, {.files = 3}, {});
  CHECK(nlohmann::ordered_json::parse(text).dump(2) + "\n" == text);
}

TEST_CASE("JSON lines are the objects of the JSON form, one a line") {
  FullExample const example;
  auto bare = error_at(place_of(example.sources, example.list, "LOWPASS"), "bare \"quoted\"\n{\x01}");
  std::vector<Finding> const findings{example.finding, bare};
  auto const document =
      nlohmann::ordered_json::parse(write_json(findings, example.sources, {.files = 1}, {}));
  std::string lines;
  for (auto const& object : document["diagnostics"]) lines += object.dump() + "\n";
  CHECK(whole_report(FindingFormat::jsonl, findings, example.sources) == lines);
  CHECK(whole_report(FindingFormat::jsonl, {}, {}) == "");
}
