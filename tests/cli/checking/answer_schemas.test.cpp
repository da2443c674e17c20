// What programs read of findings and answers is as the published JSON schemas say. run_axisc() compares every
// answer in JSON with its schema; here are the samples, and that the schemas can refuse.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

namespace answer_schemas_test {

using namespace axisc::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string schema_of(std::string const& name) {
  return read_source_file("docs/schemas/" + name + ".schema.json");
}

void collect_objects(json const& value, json::json_pointer const& place,
                     std::vector<json::json_pointer>& places) {
  if (value.is_object()) places.push_back(place);
  if (value.is_array() && !value.empty()) return collect_objects(value[0], place / 0, places);
  if (!value.is_object()) return;
  for (auto const& [key, member] : value.items()) collect_objects(member, place / key, places);
}

/// Refuses a member more anywhere but among those that axes name, and every answer of another version.
void check_strict(std::vector<std::string> const& arguments) {
  auto with_format = arguments;
  with_format.insert(with_format.end(), {"--format", "json"});
  auto answer = json::parse(run_axisc(with_format, in_folder(AXISC_SOURCE_DIR)).out);
  auto const schema = schema_of(arguments.front());
  std::vector<json::json_pointer> places;
  collect_objects(answer, json::json_pointer(), places);
  REQUIRE_FALSE(places.empty());
  std::set<std::string> const by_axis = {"axis_error_um", "max_acceleration_mm_s2", "max_jerk_mm_s3"};
  for (auto const& place : places) {
    if (!place.empty() && by_axis.contains(place.back())) continue;
    INFO(arguments.front() << " " << place.to_string());
    auto longer = answer;
    longer[place]["no_member"] = 1;
    CHECK_FALSE(schema_complaints(longer.dump(), schema).empty());
  }
  answer["version"] = 99;
  CHECK_FALSE(schema_complaints(answer.dump(), schema).empty());
}

}  // namespace

TEST_CASE("every schema is printed, as it is published") {
  std::size_t count = 0;
  for (auto const& entry : fs::directory_iterator(fs::path(AXISC_SOURCE_DIR) / "docs/schemas")) {
    auto const file = entry.path().filename().string();
    if (!file.ends_with(".schema.json")) continue;
    ++count;
    auto const name = file == "schema-file.schema.json" ? "schema" : file.substr(0, file.find('.'));
    auto const outcome = run_axisc({"schema", name});
    CHECK(outcome.status == 0);
    CHECK(outcome.out == read_source_file("docs/schemas/" + file));
  }
  CHECK(count == 21);
  auto const refused = run_axisc({"schema", "list"});
  CHECK(refused.status == 2);
  CHECK(refused.err ==
        "axisc: error: axisc schema does not know \"list\"; choose from certify, circle, compare, contour, "
        "diff, explain, filters, finding, fix, get, identify, inspect, machine, machines, plant, replay, "
        "response, schema, settings, simulate, suggest\n");
  CHECK(run_axisc({"schema"}).status == 2);
}

TEST_CASE("the findings that are written are as their schema says") {
  auto const outcome = run_axisc({"lint", "samples", "validator/rules", "--pedantic", "--format", "jsonl"},
                                 in_folder(AXISC_SOURCE_DIR));
  std::istringstream lines(outcome.out);
  std::size_t count = 0;
  auto const schema = schema_of("finding");
  for (std::string line; std::getline(lines, line); ++count) {
    CHECK(schema_complaints(line, schema) == std::vector<std::string>());
  }
  CHECK(count > 100);
}

TEST_CASE("answers about the samples are as their schemas say") {
  TemporaryFolder const folder;
  std::size_t answers = 0;
  auto const check = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--format", "json"});
    answers += run_axisc(arguments, in_folder(AXISC_SOURCE_DIR)).out.empty() ? 0 : 1;
  };
  for (std::string const machine : {"controller", "controller-xml", "controller-project", "mill", "motion",
                                    "motion/rack", "resonance", "tutorial"}) {
    auto const path = "samples/" + machine;
    check({"machine", path});
    check({"contour", path});
    check({"diff", "samples/mill", path});
    check({"get", path, "X", "--all"});
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(AXISC_SOURCE_DIR) / path)) {
      if (entry.path().extension() == ".nc") check({"simulate", path, "--program", entry.path().string()});
    }
  }
  for (auto const& entry : fs::directory_iterator(fs::path(AXISC_SOURCE_DIR) / "samples/manual")) {
    auto const image = folder / "image.axim";
    if (run_axisc({"compile", entry.path().string(), "-o", image, "--cycle-time", "1ms", "--quiet"}).status !=
        0)
      continue;
    check({"inspect", image});
    check({"response", image, "--frequencies", "1,10,100"});
  }
  for (std::string const word : {"filter", "Endschalter", "Kerbfilter", "50663", "#FILTER", "2009"}) {
    check({"explain", word});
  }
  CHECK(answers > 40);
}

TEST_CASE("the schemas of answers refuse what is not in them") {
  TemporaryFolder const folder;
  auto const image = folder / "mill.axim";
  REQUIRE(
      run_axisc({"compile", "samples/mill", "-o", image, "--quiet"}, in_folder(AXISC_SOURCE_DIR)).status ==
      0);
  auto const record = folder / "mill.axrd";
  REQUIRE(run_axisc({"run", image, "--cycles", "20", "--record", record}).status == 0);
  check_strict({"inspect", image});
  check_strict({"replay", image, record});
  check_strict({"response", image, "--frequencies", "1"});
  check_strict({"contour", "samples/mill"});
  check_strict({"diff", "samples/mill", "samples/resonance"});
  check_strict({"explain", "AX3005"});
  check_strict({"explain", "filter[0].order"});
  check_strict({"explain", "50663"});
  check_strict({"explain", "BANDSTOP"});
  check_strict({"get", "samples/mill", "X", "--all"});
  check_strict({"simulate", "samples/mill", "--program", "samples/mill/part.nc"});
  check_strict({"contour", "samples/motion/square", "--budget"});
  check_strict({"suggest", "samples/resonance", "--axis", "X", "--resonance", "48Hz"});
  check_strict({"suggest", "samples/resonance", "--axis", "X", "--resonance", "48Hz", "--slope", "TRAPEZ"});
  check_strict(
      {"circle", "samples/circle", "samples/circle/ccw.csv", "samples/circle/cw.csv", "--tolerance", "5"});
  check_strict({"compare", "samples/recording/x.lis", "samples/recording/scope.csv", "--cycle-time", "1ms"});
  check_strict({"compare", "samples/recording/motion", "samples/recording/motion/scope.csv", "--program",
                "samples/recording/motion/tell.nc"});
}

}  // namespace answer_schemas_test
