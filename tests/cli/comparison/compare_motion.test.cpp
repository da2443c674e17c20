// A recorded program beside its plan. The sample is computed by tests/analysis/comparison/motion_control.py,
// another program, with two readings that are not the defaults.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <sstream>

#include <nlohmann/json.hpp>

namespace compare_motion_test {

using namespace axisc::test;
using nlohmann::json;

namespace {

std::string const sample = "samples/recording/motion/";

std::string sample_file(std::string const& name) {
  return read_source_file(sample + name);
}

/// A copy of the sample in which files may be changed.
struct Sample {
  TemporaryFolder folder;

  Sample() {
    for (std::string const name : {"machine.json", "x.lis", "y.lis", "channel.lis", "tell.nc", "scope.csv"}) {
      folder.write(name, sample_file(name));
    }
  }
  [[nodiscard]] Outcome compare(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"compare", "machine.json", "scope.csv", "--program", "tell.nc"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_axisc(arguments, in_folder(folder.path()));
  }
  [[nodiscard]] json told(std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--format", "json"});
    auto const outcome = compare(more);
    INFO(outcome.err);
    return json::parse(outcome.out);
  }
};

json row_of(json const& answer, std::string const& key) {
  for (auto const& row : answer["readings"]) {
    if (row["key"] == key) return row;
  }
  return {};
}

/// Lines of a text for which `keeps(number from 1, line)` holds.
template <class Keeps>
std::string lines_of(std::string const& text, Keeps keeps) {
  std::istringstream lines(text);
  std::string kept;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    if (keeps(++number, line)) kept += line + "\n";
  }
  return kept;
}

std::string replaced(std::string text, std::string const& what, std::string const& with) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

}  // namespace

TEST_CASE("the readings of a recorded control are told, written, and then in force") {
  Sample const there;
  auto const answer = there.told();
  CHECK(answer["verdict"] == "different");
  CHECK(answer["best"]["largest"].get<double>() <= answer["allowed_largest"].get<double>());
  CHECK(answer["current"]["largest"].get<double>() > 100);
  json const readings = {{"projection", "weakest-jerk"}, {"borders", "rest"},
                         {"sine", "whole-change"},       {"circle", "full"},
                         {"corner", "per-cycle"},        {"weights", "r-follows-a"},
                         {"cycles", "continuous"},       {"hsc", "stretches"}};
  for (auto const& [key, word] : readings.items()) {
    auto const row = row_of(answer, key);
    INFO(key);
    CHECK(row["reading"] == word);
    CHECK(row["possible"] == json{word});
    CHECK(row["next"] != word);
    CHECK(row["next_largest"].get<double>() > 1);
  }
  CHECK(row_of(answer, "sine")["in_force"] == "ramps");
  CHECK(there.compare().status == 1);

  auto const emitted = there.compare({"--emit", "settings"});
  CHECK(emitted.status == 0);
  CHECK(emitted.err.empty());
  CHECK(json::parse(emitted.out) == json{{"motion", readings}});
  there.folder.write("axisc.json", emitted.out);
  CHECK(there.compare().status == 0);
  CHECK(there.told()["verdict"] == "same");
}

TEST_CASE("the program of a machine is the one that was recorded, and simulate follows it") {
  Sample const there;
  auto const emitted =
      run_axisc({"compare", "machine.json", "--emit", "program"}, in_folder(there.folder.path()));
  CHECK(emitted.status == 0);
  CHECK(emitted.out == sample_file("tell.nc"));
  auto const simulated =
      run_axisc({"simulate", "machine.json", "--program", "tell.nc"}, in_folder(there.folder.path()));
  CHECK(simulated.status == 0);
  CHECK(simulated.err.empty());
}

TEST_CASE("programs of other machines say what cannot be told, and are followed") {
  TemporaryFolder const folder;
  auto const emitted = [&](std::string const& language) {
    auto const outcome = run_axisc({"compare", "machine.json", "--emit", "program", "--lang", language},
                                   in_folder(folder.path()));
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    folder.write("tell.nc", outcome.out);
    auto const simulated =
        run_axisc({"simulate", "machine.json", "--program", "tell.nc"}, in_folder(folder.path()));
    CHECK(simulated.status == 0);
    CHECK(simulated.err.empty());
    CHECK(outcome.out.find('{') == std::string::npos);  // every placeholder is filled
    return outcome.out;
  };
  std::string const rotary = "kenngr.achs_typ 2\nEnde\n";
  folder.write("a.lis", "kenngr.achs_typ 1\nEnde\n");
  folder.write("c.lis", rotary);
  SECTION("one axis has neither lines between axes nor circles nor corners") {
    folder.write("machine.json", R"({"cycle_time_us": 2000, "axes": [{"name": "X1", "list": "a.lis"}],
                                     "groups": [{"axes": ["X1"]}]})");
    auto const text = emitted("en");
    for (std::string const key : {"projection", "circle", "corner", "weights"}) {
      CHECK_THAT(text, Catch::Matchers::Contains("; " + key + " ("));
    }
    CHECK_THAT(text, Catch::Matchers::Contains("A recording tells: borders, sine, cycles, hsc.") &&
                         Catch::Matchers::Contains("G01 X1=2 F") && Catch::Matchers::Contains("; X1: 0 to "));
    CHECK_THAT(emitted("de"), Catch::Matchers::Contains("lässt sich an dieser Maschine nicht feststellen"));
  }
  SECTION("alike axes do not tell the projection") {
    folder.write("machine.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "a.lis"},
                                     {"name": "Y", "list": "a.lis"}, {"name": "C", "list": "c.lis"}],
                                     "groups": [{"axes": ["X", "Y", "C"]}]})");
    auto const text = emitted("en");
    CHECK_THAT(text, Catch::Matchers::Contains("; projection (") &&
                         Catch::Matchers::Contains("tells: borders, sine, circle, corner, weights, cycles"));
  }
  SECTION("rotary axes move by degrees") {
    folder.write("machine.json", R"({"cycle_time_us": 1000, "axes": [{"name": "C", "list": "c.lis"}],
                                     "groups": [{"axes": ["C"]}]})");
    CHECK_THAT(emitted("en"), Catch::Matchers::Contains("; C: ") && Catch::Matchers::Contains("°"));
  }
}

TEST_CASE("what a program does not show is left open") {
  Sample const there;
  // Only the first part: one short block with TRAPEZ, there and back.
  there.folder.write("tell.nc", lines_of(sample_file("tell.nc"), [](int, std::string const& line) {
                       auto const at = line.find(' ');
                       bool const is_numbered = line.starts_with("N") && at != std::string::npos;
                       return is_numbered && std::stoi(line.substr(1, at)) <= 80;
                     }));
  auto const answer = there.told();
  CHECK(answer["moves"] == 2);
  CHECK(answer["verdict"] == "same");
  CHECK(row_of(answer, "cycles")["reading"] == "continuous");
  CHECK(row_of(answer, "sine")["reading"].is_null());
  CHECK(row_of(answer, "sine")["acts"] == false);
  CHECK(row_of(answer, "sine")["possible"] == json({"ramps", "whole-change", "same-peak-jerk"}));
  CHECK_THAT(there.compare().out, Catch::Matchers::Contains("\"sine\" is left open") &&
                                      Catch::Matchers::Contains("--emit program"));
  CHECK_THAT(there.compare({"--lang", "de"}).out, Catch::Matchers::Contains("\"sine\" bleibt offen"));
  auto const emitted = there.compare({"--emit", "settings"});
  CHECK(emitted.status == 0);  // the control plans as axisc does
  CHECK(json::parse(emitted.out) == json::parse(R"({"motion": {"cycles": "continuous"}})"));
  CHECK_THAT(emitted.err, Catch::Matchers::Contains("\"sine\" is left open"));
}

TEST_CASE("a control that is none of the readings is told nothing") {
  Sample const there;
  there.folder.write("x.lis", replaced(sample_file("x.lis"), "a_brems         2000", "a_brems 1990"));
  there.folder.write("y.lis", replaced(sample_file("y.lis"), "a_brems         1500", "a_brems 1490"));
  auto const answer = there.told();
  CHECK(answer["verdict"] == "none-fits");
  for (auto const& row : answer["readings"]) CHECK(row["reading"].is_null());
  auto const emitted = there.compare({"--emit", "settings"});
  CHECK(emitted.status == 1);
  CHECK(emitted.out.empty());
  CHECK_THAT(emitted.err, Catch::Matchers::Contains("tells no reading"));
  CHECK_THAT(there.compare({"--lang", "de"}).out, Catch::Matchers::Contains("keine Kombination"));
}

TEST_CASE("a move that no reading explains keeps others from nothing") {
  Sample const there;
  // v³/r² ≤ 1.5 m/s² / 0.2 s on the circle of 2 mm: 31 mm/s instead of 50.
  there.folder.write("y.lis", replaced(sample_file("y.lis"), "tr_geom              10000", "tr_geom 200000"));
  auto const answer = there.told();
  CHECK(answer["verdict"] == "different");
  REQUIRE(answer["unexplained"].size() == 1);
  CHECK(answer["unexplained"][0]["block"] == "N250");
  CHECK(answer["unexplained"][0]["largest"].get<double>() > 100);
  for (auto const& row : answer["readings"]) {
    INFO(row["key"]);
    CHECK(row["reading"].is_null() == (row["key"] == "circle"));
  }
  CHECK_THAT(there.compare().out, Catch::Matchers::Contains("no known reading explains"));
  auto const emitted = there.compare({"--emit", "settings"});
  CHECK(emitted.status == 1);
  CHECK(json::parse(emitted.out)["motion"].size() == 7);
}

TEST_CASE("one axis is enough where it moves, and columns are named") {
  Sample const there;
  there.folder.write("scope.csv", replaced(sample_file("scope.csv"), "X\tY", "soll\tandere"));
  auto const refused = there.compare();
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Catch::Matchers::Contains("has no column for an axis of the channel (X, Y)") &&
                              Catch::Matchers::Contains("--in AXIS=COLUMN"));
  CHECK_THAT(there.compare({"--lang", "de"}).err, Catch::Matchers::Contains("--in ACHSE=SPALTE"));
  auto const answer = there.told({"--in", "X=soll"});
  CHECK(answer["axes"] == json{"X"});
  CHECK(row_of(answer, "circle")["reading"] == "full");
  CHECK(row_of(answer, "sine")["reading"] == "whole-change");
  CHECK(there.told({"--in", "X=2", "--in", "Y=andere"})["axes"] == json({"X", "Y"}));
  CHECK_THAT(there.compare({"--in", "Z=soll"}).err,
             Catch::Matchers::Contains("the channel has the axes X, Y"));
  CHECK_THAT(there.compare({"--in", "soll"}).err, Catch::Matchers::Contains("--in X=COLUMN"));
}

TEST_CASE("recordings and programs that cannot be compared are refused with what helps") {
  Sample const there;
  auto const refused = [&](std::string const& english, std::string const& german, int status = 2) {
    auto const outcome = there.compare();
    CHECK(outcome.status == status);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Catch::Matchers::Contains(english));
    CHECK_THAT(there.compare({"--lang", "de"}).err, Catch::Matchers::Contains(german));
  };
  SECTION("a recording that ends too early") {
    there.folder.write("scope.csv", lines_of(sample_file("scope.csv"),
                                             [](int at, std::string const&) { return at < 6000; }));
    refused("record from the rest before the program to the rest after it",
            "vom Stillstand vor dem Programm");
  }
  SECTION("another cycle") {
    there.folder.write("machine.json", replaced(sample_file("machine.json"), "1000", "1500"));
    refused("record with the NC cycle", "mit dem NC-Zyklus aufzeichnen");
  }
  SECTION("rests that are too short") {
    there.folder.write("tell.nc", replaced(sample_file("tell.nc"), "G04 F0.3", "G04 F0.1"));
    refused("tell.nc:16: the path stops here for less than 0.2 s", "kürzer als 0,2 s");
    CHECK_THAT(there.compare({"--lang", "de"}).err, Catch::Matchers::Contains("`G04 F0.2`"));
  }
  SECTION("filters in the program") {
    there.folder.write("tell.nc", "%P\n#FILTER OFF\nG01 X1 F100\nM30\n");
    refused("tell.nc:2: #FILTER may change", "tell.nc:2: #FILTER kann ändern");
  }
  SECTION("nothing that moves") {
    there.folder.write("tell.nc", "%P\nM30\n");
    refused("moves no axis", "bewegt keine Achse");
  }
  SECTION("a program that is not followed") {
    there.folder.write("tell.nc", "%P\nG41\nM30\n");
    refused("tell.nc:2:1", "tell.nc:2:1", 1);
  }
  SECTION("options that mean something else") {
    CHECK(there.compare({"--axis", "X"}).status == 2);
    CHECK(there.compare({"--emit", "program"}).status == 2);
    auto const group =
        run_axisc({"compare", "x.lis", "scope.csv", "--group", "channel 1"}, in_folder(there.folder.path()));
    CHECK_THAT(group.err, Catch::Matchers::Contains("--axis names the axis"));
  }
}

}  // namespace compare_motion_test
