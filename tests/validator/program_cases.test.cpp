// tests/data/program_cases.txt: NC programs and machines with the findings they must give, and no other.
#include "support/catch.hpp"
#include "support/map_files.hpp"
#include "validator/check.hpp"
#include "validator/loading/build_version.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace program_cases_test {

namespace {

using namespace axisc;

struct Case {
  std::string name;
  std::string cycle_time_us;
  bool pedantic = false;
  std::string build;
  std::vector<std::string> names;  ///< of the files, in their order
  std::map<std::string, std::string> files;
  std::vector<std::string> expected;  ///< "part.nc 12 AX5001", sorted
};

bool ends_in(std::string const& text, std::string const& end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// `== name | T=1000 pedantic`
Case heading(std::string const& line) {
  auto const bar = line.find(" | ");
  REQUIRE(bar != std::string::npos);
  Case one;
  one.name = line.substr(3, bar - 3);
  std::istringstream words(line.substr(bar + 3));
  for (std::string word; words >> word;) {
    if (word.rfind("T=", 0) == 0) one.cycle_time_us = word.substr(2);
    if (word == "pedantic") one.pedantic = true;
    if (word.rfind("build=", 0) == 0) one.build = word.substr(6);
  }
  return one;
}

std::vector<Case> read_cases() {
  std::ifstream in(AXISC_SOURCE_DIR "/tests/data/program_cases.txt");
  std::vector<Case> cases;
  std::string file;
  unsigned line_number = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("== ", 0) == 0) {
      cases.push_back(heading(line));
      file.clear();
    } else if (line.rfind("-- ", 0) == 0) {
      file = line.substr(3);
      cases.back().names.push_back(file);
      cases.back().files[file];
      line_number = 0;
    } else if (!file.empty()) {
      ++line_number;
      auto const mark = line.find(" <- ");
      cases.back().files[file] += line.substr(0, mark) + "\n";
      std::istringstream codes(mark == std::string::npos ? "" : line.substr(mark + 4));
      for (std::string code; codes >> code;) {
        cases.back().expected.push_back(file + " " + std::to_string(line_number) + " " + code);
      }
    }
  }
  for (auto& one : cases) std::sort(one.expected.begin(), one.expected.end());
  return cases;
}

/// A machine of all lists and programs of the case.
std::string machine_of(Case const& one) {
  std::string axes;
  std::string programs;
  for (auto const& name : one.names) {
    if (ends_in(name, ".nc")) {
      programs += (programs.empty() ? "\"" : ", \"") + name + "\"";
    } else {
      std::string axis = name.substr(0, name.find('.'));
      std::transform(axis.begin(), axis.end(), axis.begin(),
                     [](char c) { return static_cast<char>(c - 'a' + 'A'); });
      axes += (axes.empty() ? "{" : ", {") + ("\"name\": \"" + axis) + "\", \"list\": \"" + name + "\"}";
    }
  }
  return R"({"cycle_time_us": )" + one.cycle_time_us + R"(, "axes": [)" + axes + R"(], "programs": [)" +
         programs + "]}";
}

std::vector<std::string> findings_of(Case one) {
  validator::CheckOptions options;
  options.pedantic = one.pedantic;
  options.build = validator::parse_build_version(one.build);
  bool const has_list =
      std::any_of(one.names.begin(), one.names.end(), [](auto const& name) { return ends_in(name, ".lis"); });
  std::string input = "machine.json";
  if (!has_list) {
    input = one.names.front();
    options.cycle_time = design::CycleTime{static_cast<std::uint32_t>(std::stod(one.cycle_time_us) * 1e3)};
  } else if (one.files.count(input) == 0) {
    one.files[input] = machine_of(one);
  }
  tests::MapFiles files(one.files);
  SourceSet sources;
  auto const result = validator::check(files, input, options, sources);
  CHECK_FALSE(result.unreadable.has_value());
  std::vector<std::string> found;
  for (auto const& finding : result.findings) {
    if (!finding.place) continue;
    SourceText const& source = sources[finding.place->source];
    found.push_back(source.name() + " " + std::to_string(source.position(finding.place->span.begin).line) +
                    " " + code_text(finding.code));
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

TEST_CASE("every case with programs gives its findings and no other") {
  auto const cases = read_cases();
  REQUIRE(cases.size() > 50);
  for (auto const& one : cases) {
    INFO("case: " << one.name);
    CHECK(findings_of(one) == one.expected);
  }
}

}  // namespace program_cases_test
