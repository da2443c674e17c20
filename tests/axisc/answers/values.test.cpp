// The value in force, compared with two others: what a reading of the lists as plain words gives, and the
// machine that is compiled.
#include "axisc/answers/values/values_answer.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/workspace/workspace.hpp"
#include "presentation/writers.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "validator/check.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc;
using axisc::test::TemporaryFolder;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

json values_of(std::string const& input, std::vector<std::string> words, bool all = false) {
  Workspace workspace;
  auto const answer =
      values_answer(workspace, {.machine = {.input = input}, .words = std::move(words), .all = all});
  return json::parse(presentation::write(answer, presentation::Format::json, {}));
}

struct PlainLine {
  std::string value, file;
  std::size_t line = 0;
};
using PlainLines = std::map<std::string, PlainLine>;

/// The first two words of each line, as if nothing else belonged to the language of lists.
void read_plainly(PlainLines& lines, fs::path const& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  for (std::size_t number = 1; std::getline(file, text); ++number) {
    std::istringstream words(text);
    std::string name;
    std::string value;
    words >> name >> value;
    if (name == "Ende") return;
    if (value.empty() || name.front() == '#' || name.front() == '(') continue;
    lines[name] = {.value = value, .file = path.filename().string(), .line = number};
  }
}

struct SampleAxis {
  fs::path machine;
  std::string name;
  PlainLines lines;
};

/// Of a start-up list, whose names of lists lead from the folder above.
void add_started_axes(std::vector<SampleAxis>& axes, fs::path const& start_up) {
  PlainLines named;
  read_plainly(named, start_up);
  auto const folder = start_up.parent_path().parent_path();
  for (auto const& [parameter, line] : named) {
    if (!parameter.starts_with("achs_mds[")) continue;
    SampleAxis sample{.machine = start_up, .name = {}, .lines = {}};
    read_plainly(sample.lines, folder / named.at("default_achs_mds").value);
    read_plainly(sample.lines, folder / line.value);
    sample.name = sample.lines.at("kopf.log_achs_name").value;
    axes.push_back(std::move(sample));
  }
}

std::vector<SampleAxis> sample_axes() {
  std::vector<SampleAxis> axes;
  add_started_axes(axes, fs::path(AXISC_SOURCE_DIR) / "samples/controller/listen/hochlauf.lis");
  for (auto const& entry : fs::recursive_directory_iterator(fs::path(AXISC_SOURCE_DIR) / "samples")) {
    if (entry.path().filename() != "machine.json") continue;
    std::ifstream file(entry.path());
    auto const machine = json::parse(file);
    auto const folder = entry.path().parent_path();
    for (auto const& axis : machine["axes"]) {
      SampleAxis sample{.machine = entry.path(), .name = axis["name"], .lines = {}};
      if (machine.contains("default_list")) {
        read_plainly(sample.lines, folder / machine["default_list"].get<std::string>());
      }
      read_plainly(sample.lines, folder / axis["list"].get<std::string>());
      axes.push_back(std::move(sample));
    }
  }
  return axes;
}

std::optional<double> number_of(std::string const& text) {
  char* end = nullptr;
  double const number = std::strtod(text.c_str(), &end);
  return *end == '\0' ? std::optional(number) : std::nullopt;
}

}  // namespace

TEST_CASE("an index that no entry has is refused, and what may be meant is named") {
  auto const machine = std::string(AXISC_SOURCE_DIR) + "/samples/mill/machine.json";
  auto const refusal = [&machine](std::string const& word) {
    try {
      static_cast<void>(values_of(machine, {"X", word}));
    } catch (Failure const& failure) {
      return failure.sentence(Language::english);
    }
    return std::string();
  };
  CHECK(refusal("filter[9].order") ==
        "there is no `filter[9].order`; write one of filter[0].order to filter[2].order");
  // Entries that there are, are no answer for one that there is not.
  CHECK(refusal("filter[9].typ").starts_with("there is no axis parameter \"filter[9].typ\"; did you mean "));
  CHECK(refusal("filter[1].fgf0").ends_with("did you mean filter[1].fg_f0?"));
  CHECK(refusal("vb_maxx").ends_with("did you mean getriebe[0].dynamik.vb_max, handbetrieb.hb.vb_max?"));
  CHECK(refusal("nonsense_param").ends_with("`axisc explain` finds names by what they mean"));
}

TEST_CASE("values in force are those of the lines that plain reading finds") {
  std::size_t compared = 0;
  std::size_t left_out = 0;
  for (auto const& [machine, name, lines] : sample_axes()) {
    auto const answer = values_of(machine.string(), {name}, true);
    std::map<std::string, json> values;
    for (auto const& value : answer["values"]) values[value["parameter"]] = value;
    for (auto const& [parameter, line] : lines) {
      INFO(machine.string() << " " << name << " " << parameter);
      if (!values.contains(parameter)) {  // a mistake that is the sample's subject
        ++left_out;
        continue;
      }
      auto const& value = values[parameter];
      if (!value["usable"]) continue;
      CHECK(fs::path(value["file"].get<std::string>()).filename() == line.file);
      CHECK(value["line"] == line.line);
      ++compared;
      if (value["reference"]) {
        CHECK(line.value.starts_with("P-AXIS-"));
        continue;
      }
      auto const number = number_of(line.value);
      if (number && value["number"].is_number()) {
        CHECK(value["number"] == *number);
      } else {
        CHECK(value["written"] == line.value);
      }
    }
    for (auto const& [parameter, value] : values) {
      INFO(machine.string() << " " << name << " " << parameter);
      bool const is_set = !value["file"].is_null() && value["usable"];
      CHECK((!is_set || lines.contains(parameter)));
    }
  }
  CHECK(compared > 500);
  CHECK(left_out < compared / 50);
}

TEST_CASE("values in force are those of the compiled machine") {
  std::size_t compared = 0;
  for (auto const& [path, name, lines] : sample_axes()) {
    Workspace workspace;
    SourceSet sources;
    auto const result =
        validator::check(workspace.files(), path.string(), workspace.options_of(path.string()), sources);
    if (!result.machine) continue;
    auto const& axes = result.machine->axes;
    auto const found = std::find_if(axes.begin(), axes.end(),
                                    [&, &wanted = name](auto const& axis) { return axis.name == wanted; });
    REQUIRE(found != axes.end());
    auto const number = [&, &machine = path, &axis = name](std::string const& parameter) {
      auto const values = values_of(machine.string(), {axis, parameter})["values"];
      REQUIRE(values.size() == 1);
      return values[0]["number"].get<double>();
    };
    INFO(path.string() << " " << name);
    CHECK(number("kopf.achs_nr") == found->number);
    CHECK(number("getriebe[0].dynamik.vb_max") == found->velocity_limit);
    CHECK(number("getriebe[0].dynamik.a_max") == found->acceleration_limit);
    CHECK(number("kenngr.filter_position_window") == found->position_window);
    for (auto const& filter : found->filters) {
      auto const at = "filter[" + std::to_string(filter.index) + "].";
      auto const& specification = filter.specification;
      CHECK(number(at + "enable") == 1);
      CHECK(number(at + "type") == static_cast<double>(specification.type));
      CHECK(number(at + "fg_f0") == specification.frequency.value);
      CHECK(number(at + "share_percent") == specification.share_percent);
      ++compared;
    }
    // Everything that the machine says its lists set.
    auto const all = values_of(path.string(), {name}, true);
    std::map<std::string, std::string> written;
    for (auto const& value : all["values"]) written[value["parameter"]] = value["written"];
    for (auto const& value : found->values) {
      INFO(value.name);
      CHECK(written.at(value.name) == value.text);
    }
    CHECK(written.size() >= found->values.size());
  }
  CHECK(compared > 5);
}

TEST_CASE("a value says where it comes from") {
  TemporaryFolder const folder;
  folder.write("default.lis", "kopf.achs_nr 0\nfilter[1].order 2\nEnde\n");
  folder.write("x.lis",
               "kopf.achs_nr 1\ngetriebe[0].dynamik.vb_max 200000\ngetriebe[0].vb_eilgang P-AXIS-00212.0\n"
               "getriebe[0].kv 12abc\nEnde\n");
  auto const machine = folder.write("machine.json", R"({"machine": "m", "cycle_time_us": 1000,
    "default_list": "default.lis", "axes": [{"name": "X", "list": "x.lis"}]})");
  auto const one = [&](std::string const& parameter) {
    auto const values = values_of(machine, {"X", parameter})["values"];
    REQUIRE(values.size() == 1);
    return values[0];
  };
  auto const own = one("getriebe[0].dynamik.vb_max");
  CHECK(own["origin"] == "axis_list");
  CHECK(own["line"] == 2);
  CHECK(own["unit"] == "um/s");
  CHECK(one("filter[1].order")["origin"] == "default_list");
  CHECK(one("filter[2].order")["origin"] == "default");
  CHECK(one("filter[2].order")["value"] == "0");
  auto const rapid = one("Eilganggeschwindigkeit");
  CHECK(rapid["parameter"] == "getriebe[0].vb_eilgang");
  CHECK(rapid["reference"] == true);
  CHECK(rapid["number"] == 200000);
  CHECK(rapid["written"] == "P-AXIS-00212.0");
  // The control reads 0 where a number cannot be read (message 1001138).
  auto const gain = one("Kv");
  CHECK(gain["usable"] == false);
  CHECK(gain["finding"] == "AX1006");
  CHECK(gain["control_value"] == "0");
  // The list of one axis needs no name of it, a machine of one neither.
  CHECK(values_of(folder / "x.lis", {"filter[1].order"})["values"][0]["origin"] == "default_list");
  CHECK(values_of(machine, {"P-AXIS-00212"})["values"][0]["number"] == 200000);
  CHECK(values_of(machine, {"X", "getriebe"})["values"].size() == 3);
}

TEST_CASE("what names no value is refused") {
  auto const mill = std::string(AXISC_SOURCE_DIR) + "/samples/mill/machine.json";
  auto const refusal = [&](std::vector<std::string> words) {
    try {
      static_cast<void>(values_of(mill, std::move(words)));
    } catch (Failure const& failure) {
      return failure.sentence(Language::english);
    }
    return std::string();
  };
  CHECK_THAT(refusal({"Q", "filter[0].order"}), Catch::Matchers::Contains("Q"));
  CHECK_THAT(refusal({}), Catch::Matchers::Contains("name the axis: X, Y, Z"));
  CHECK(refusal({"X"}) == "name a parameter, or --all");
  CHECK_THAT(refusal({"X", "xyzzy"}), Catch::Matchers::Contains("xyzzy"));
  CHECK_THAT(refusal({"X", "AX3005"}), Catch::Matchers::Contains("there is no axis parameter \"AX3005\""));
}
