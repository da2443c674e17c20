#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

std::string const schema = R"({
  "version": 1,
  "parameters": [
    {"id": "P-AXIS-00900", "name": "getriebe[].new_limit", "type": "UNS16", "array": [6], "default": "0", "unit": "us",
     "minimum": 1, "maximum": 500},
    {"name": "kenngr.new_mode", "type": "STRING", "default": "OFF", "symbols": {"OFF": 0, "SOFT": 1}},
    {"name": "filter[].share_percent", "maximum": 90}
  ]
})";

/// "4 AX2005", one line per finding.
std::string findings(TemporaryFolder const& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"lint", "--cycle-time", "1ms", "--format", "json"});
  auto const outcome = run_axisc(arguments, in_folder(folder.path()));
  INFO(outcome.err);
  std::string lines;
  auto const json = nlohmann::json::parse(outcome.out);
  for (auto const& finding : json["diagnostics"]) {
    lines += std::to_string(finding["line"].get<int>()) + " " + finding["code"].get<std::string>() + "\n";
  }
  return lines;
}

}  // namespace

TEST_CASE("parameters of a schema file are known, and what they must not be is reported") {
  TemporaryFolder const folder;
  folder.write("extra.json", schema);
  folder.write(
      "x.lis",
      "getriebe[0].new_limit 600\ngetriebe[1].new_limit 70000\ngetriebe[6].new_limit 5\n"
      "getriebe[2].new_limt 5\nkenngr.new_mode SOF\nKenngr.new_mode SOFT\nfilter[0].share_percent 95\n"
      "getriebe[3].new_limit P-AXIS-00900.4 ( P-AXIS-00900\nEnde\n");
  CHECK(findings(folder, {"x.lis", "--schema", "extra.json"}) ==
        "1 AX2005\n2 AX2004\n3 AX2002\n4 AX2001\n5 AX2007\n6 AX1010\n7 AX2005\n");
  CHECK(findings(folder, {"x.lis"}).find("7 AX2005") == std::string::npos);
  auto const text =
      run_axisc({"lint", "x.lis", "--schema", "extra.json", "--lang", "en"}, in_folder(folder.path()));
  CHECK_THAT(text.out, Contains("0 % ≤ share_percent ≤ 90 %") && Contains("= limit from extra.json"));
}

TEST_CASE("fixes and the layout know the names of a schema file") {
  TemporaryFolder const folder;
  folder.write("extra.json", schema);
  folder.write("x.lis", "getriebe[2].new_limt 5 ( limit\nKenngr.new_mode SOFT\n");
  auto const there = in_folder(folder.path());
  static_cast<void>(run_axisc({"lint", "x.lis", "--fix=all", "--schema", "extra.json"}, there));
  CHECK(folder.read("x.lis") == "getriebe[2].new_limit 5 ( limit\nkenngr.new_mode SOFT\n");
  CHECK(run_axisc({"fmt", "x.lis", "--schema", "extra.json"}, there).status == 0);
  CHECK(folder.read("x.lis") == "getriebe[2].new_limit  5  ( limit\nkenngr.new_mode        SOFT\n");
}

TEST_CASE("explain shows what a schema file says and that it says it") {
  TemporaryFolder const folder;
  folder.write("extra.json", schema);
  auto const there = in_folder(folder.path());
  CHECK(run_axisc({"explain", "getriebe[].new_limit"}, there).status == 2);
  auto const english = run_axisc({"explain", "P-AXIS-00900", "--schema", "extra.json"}, there).out;
  CHECK_THAT(english, Contains("range: 1 ≤ value ≤ 500") && Contains("from: extra.json"));
  auto const german =
      run_axisc({"explain", "filter[0].share_percent", "--schema", "extra.json", "--lang", "de"}, there).out;
  CHECK_THAT(german, Contains("aus: extra.json") && Contains("≤ 90"));
  auto const json = nlohmann::json::parse(
      run_axisc({"explain", "kenngr.new_mode", "--schema", "extra.json", "--format", "json"}, there).out);
  CHECK(json["parameters"][0]["file"] == "extra.json");
}

TEST_CASE("the settings name schema files, and those of the command line win") {
  TemporaryFolder const folder;
  folder.write("schema/extra.json", schema);
  folder.write("axisc.json", R"({"schema": ["schema/extra.json"]})");
  folder.write("lists/x.lis", "getriebe[0].new_limit 600\nkenngr.new_mode SOFT\n");
  CHECK(findings(folder, {"lists/x.lis"}) == "1 AX2005\n");
  folder.write("wider.json",
               R"({"version": 1, "parameters": [{"name": "getriebe[].new_limit", "maximum": 700}]})");
  CHECK(findings(folder, {"lists/x.lis", "--schema", "wider.json"}).empty());
  auto const there = in_folder(folder.path());
  auto const config =
      run_axisc({"lint", "--print-config", "lists/x.lis", "--schema", "wider.json"}, there).out;
  CHECK_THAT(config, Contains("schema/extra.json") && Contains("wider.json"));
  folder.write("axisc.json", R"({"schema": ["missing.json"]})");
  auto const missing = run_axisc({"lint", "lists/x.lis"}, there);
  CHECK(missing.status == 2);
  CHECK_THAT(missing.err, Contains("axisc.json:1:13") && Contains("missing.json"));
}

TEST_CASE("a machine in a folder above that does not name the list is not asked for its settings") {
  TemporaryFolder const folder;
  folder.write("one/schema/extra.json", schema);
  folder.write("one/axisc.json", R"({"schema": ["schema/extra.json"]})");
  folder.write("one/x.lis", "getriebe[0].new_limit 600\n");
  folder.write("one/wider.json",
               R"({"version": 1, "parameters": [{"name": "getriebe[].new_limit", "maximum": 700}]})");
  // Without the other schema file this one is wrong.
  folder.write("machine.json", R"({"axes": [{"name": "X", "list": "two/x.lis"}]})");
  CHECK(findings(folder, {"one/x.lis", "--schema", folder / "one/wider.json"}).empty());
}

TEST_CASE("images come from lists with the parameters of a schema file, and builds depend on it") {
  TemporaryFolder const folder;
  folder.write("extra.json", schema);
  folder.write("x.lis", "kopf.log_achs_name X\ngetriebe[0].new_limit 5\nfilter[0].ordr 1\n");
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "kopf.log_achs_name X\ngetriebe[0].new_limit 5\n");
  auto const outcome = run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "1ms", "--schema",
                                  "extra.json", "--depfile", "x.d", "--werror"},
                                 there);
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK_THAT(folder.read("x.d"), Contains("extra.json"));
  CHECK(run_axisc({"diff", "x.lis", "x.axim", "--cycle-time", "1ms", "--schema", "extra.json", "--exit-code"},
                  there)
            .status == 0);
  auto const overwriting = run_axisc(
      {"compile", "x.lis", "-o", "extra.json", "--cycle-time", "1ms", "--schema", "extra.json"}, there);
  CHECK(overwriting.status == 2);
  CHECK(folder.read("extra.json") == schema);
}

TEST_CASE("what a schema file must not say is refused at its place, in both languages") {
  TemporaryFolder const folder;
  folder.write("x.lis", "Ende\n");
  auto const there = in_folder(folder.path());
  // The entry, and the column of the complaint.
  std::vector<std::pair<std::string, int>> const entries = {
      {R"({"type": "UNS08"})", 30},
      {R"({"name": "A.b", "type": "UNS08"})", 39},
      {R"({"name": "a[].b[].c[]", "type": "UNS08"})", 39},
      {R"({"name": "a.b"})", 39},
      {R"({"name": "a.b", "type": "UNS99"})", 54},
      {R"({"name": "a.b", "type": "UNS08", "id": "140"})", 69},
      {R"({"name": "a.b", "type": "UNS08", "array": [3]})", 72},
      {R"({"name": "a[].b", "type": "UNS08"})", 39},
      {R"({"name": "a[].b", "type": "UNS08", "array": [0]})", 75},
      {R"({"name": "filter.order", "type": "UNS08"})", 39},
      {R"({"name": "filter[].order", "array": [5]})", 66},
      {R"({"name": "getriebe[].dynamik.vb_max", "array": [2]})", 77},
      {R"({"name": "a.b", "type": "UNS08", "maximum": "high"})", 74},
      {R"({"name": "a.b", "type": "UNS08", "maximum": "P-AXIS-09999"})", 74},
      {R"({"name": "a.b", "type": "UNS08", "minimum": 5, "maximum": 3})", 74},
      {R"({"name": "a.b", "type": "UNS08", "minimum": 5, "exclusive_minimum": 3})", 77},
      {R"({"name": "a.b", "type": "STRING", "minimum": 5})", 64},
      {R"({"name": "a.b", "type": "STRING", "symbols": {"low": 5}})", 76},
      {R"({"name": "a.b", "type": "UNS08", "symbols": {"LOW": 5}})", 74},
      {R"({"name": "a.b", "type": "UNS08", "default": "x"})", 74},
      {R"({"name": "a.b", "type": "UNS08", "default": "P-AXIS-09999"})", 74},
      {R"({"name": "a.b", "type": "UNS08", "unit": {"rotary": "Hz"}})", 71},
      {R"({"name": "a.b", "type": "UNS08", "max_length": 5})", 77},
      {R"({"name": "a.b", "type": "UNS08", "axis_types": ["X"]})", 78},
      {R"({"name": "a.b", "type": "UNS08", "since": "3"})", 72},
      {R"({"name": "a.b", "type": "UNS08", "number_names": {"one": -1}})", 87},
      {R"({"name": "a.b", "type": "UNS08", "min": 5})", 63},
      {R"({"name": "a.b", "type": "UNS08", "id": "P-AXIS-00900", "id": "P-AXIS-00900"})", 85},
      {R"({"name": "a.b", "type": "BOOLEAN", "symbols": {"TRUE": 1}})", 76},
      {R"({"name": "a[].b[]", "type": "UNS08", "array": [1000, 1000]})", 39},
  };
  for (auto const& [entry, column] : entries) {
    folder.write("bad.json", R"({"version": 1, "parameters":[)" + entry + "]}");
    INFO(entry);
    auto const english = run_axisc({"lint", "x.lis", "--schema", "bad.json", "--lang", "en"}, there);
    auto const german = run_axisc({"lint", "x.lis", "--schema", "bad.json", "--lang", "de"}, there);
    CHECK(english.status == 2);
    CHECK(german.status == 2);
    CHECK(lines_of(english.err) == 1);
    CHECK_THAT(english.err, Contains("bad.json:1:" + std::to_string(column) + ": "));
    CHECK_THAT(german.err, Contains("bad.json:1:" + std::to_string(column) + ": "));
    CHECK(english.err != german.err);
  }
  for (
      std::string const& text :
      {std::string("{"), std::string("[]"), std::string(R"({"version": 2, "parameters": []})"),
       std::string(R"({"parameters": []})"), std::string(R"({"version": 1})"),
       std::string(R"({"version": 1, "parameters": {}})"), std::string(R"({"version": 1, "rows": []})"),
       std::string(
           R"({"version": 1, "parameters": [{"name": "a.b", "type": "UNS08"}, {"name": "a.b", "type": "UNS08"}]})")}) {
    folder.write("bad.json", text);
    INFO(text);
    auto const outcome = run_axisc({"lint", "x.lis", "--schema", "bad.json"}, there);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("bad.json:1:"));
  }
}
