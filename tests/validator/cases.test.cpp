// tests/data/cases.txt: lists with the findings they must give, and no other.
#include "support/catch.hpp"
#include "support/map_files.hpp"
#include "validator/check.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace cases_test {

namespace {

using namespace axisc;

struct Case {
  std::string name;
  std::string list;
  validator::CheckOptions options;
  std::vector<std::string> expected;  ///< "12 AX2003", sorted
};

validator::CheckOptions options_of(std::string const& text) {
  validator::CheckOptions options;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word.rfind("T=", 0) == 0)
      options.cycle_time = design::CycleTime{static_cast<std::uint32_t>(std::stod(word.substr(2)) * 1e3)};
    if (word == "type=S") options.axis_type = machine::AxisType::spindle;
    if (word == "type=R") options.axis_type = machine::AxisType::rotary;
    if (word == "pedantic") options.pedantic = true;
    if (word.rfind("build=", 0) == 0) options.build = validator::parse_build_version(word.substr(6));
  }
  return options;
}

std::vector<Case> read_cases() {
  std::ifstream in(AXISC_SOURCE_DIR "/tests/data/cases.txt");
  std::vector<Case> cases;
  unsigned line_number = 0;
  bool preamble = true;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("== ", 0) == 0) {
      preamble = false;
      auto const bar = line.find(" | ");
      cases.push_back({line.substr(3, bar - 3),
                       "",
                       options_of(bar == std::string::npos ? "" : line.substr(bar + 3)),
                       {}});
      line_number = 0;
      continue;
    }
    if (preamble) continue;
    ++line_number;
    auto const mark = line.find(" <- ");
    cases.back().list += line.substr(0, mark) + "\n";
    if (mark == std::string::npos) continue;
    std::istringstream codes(line.substr(mark + 4));
    for (std::string code; codes >> code;)
      cases.back().expected.push_back(std::to_string(line_number) + " " + code);
  }
  for (auto& one : cases) std::sort(one.expected.begin(), one.expected.end());
  return cases;
}

}  // namespace

TEST_CASE("every case gives its findings and no other") {
  auto const cases = read_cases();
  REQUIRE(cases.size() > 50);
  for (auto const& one : cases) {
    tests::MapFiles files({{"x.lis", one.list}});
    SourceSet sources;
    auto const result = validator::check(files, "x.lis", one.options, sources);
    std::vector<std::string> found;
    for (auto const& finding : result.findings) {
      if (!finding.place) continue;
      auto const position = sources[finding.place->source].position(finding.place->span.begin);
      found.push_back(std::to_string(position.line) + " " + code_text(finding.code));
    }
    std::sort(found.begin(), found.end());
    INFO("case: " << one.name);
    CHECK(found == one.expected);
  }
}

}  // namespace cases_test
