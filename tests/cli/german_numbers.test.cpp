// One decimal sign in each German text: the comma. What is to be written into a list or a program keeps the
// point.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/file_contents.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace german_numbers_test {

using namespace axisc::test;

namespace {

namespace fs = std::filesystem;

/// What a reader of the picture or page sees.
std::string without_markup(std::string_view text) {
  std::string seen;
  while (!text.empty()) {
    std::size_t const tag = std::min(text.find('<'), text.size());
    seen.append(text.substr(0, tag)).append("\n");
    text.remove_prefix(tag);
    std::string_view end = ">";
    if (text.starts_with("<script")) end = "</script>";
    if (text.starts_with("<style")) end = "</style>";
    text.remove_prefix(std::min(text.find(end), text.size()));
    text.remove_prefix(std::min(end.size(), text.size()));
  }
  return seen;
}

/// A page without the tables of what lists set: their values are shown as they are written.
std::string without_listed_values(std::string page) {
  constexpr std::string_view begin = ": was ihre Listen setzen, und wo</summary>";
  for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at)) {
    page.erase(at, page.find("</table>", at) - at);
  }
  return page;
}

/// A line that a list or a program may have: `    filter[0].fg_f0   80.8`, `filter[0].q_factor  1.5 → 2.5`.
bool is_written_so(std::string const& line) {
  static std::regex const written(R"(^\s*(\d+ [|+-] ?)?[a-z_]\w*(\[\d*\])?(\.[a-z_]\w*(\[\d*\])*)+ .*)");
  return std::regex_match(line, written);
}

/// The lines with a number that has a decimal point, outside of code spans, quoted lines, versions and
/// references.
std::vector<std::string> lines_with_points(std::string const& text) {
  static std::regex const code("`[^`]*`|#FILTER[^\\]]*\\]|P-AXIS-[0-9]+\\.[0-9]+");
  static std::regex const number(R"((^|[^\w.:=/,])[-+]?\d+\.\d+(?!\w|\.\w))");
  static std::regex const version(R"((Format|Abschnitt|axisc) +\d+\.\d+)");
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    auto const prose = std::regex_replace(std::regex_replace(line, code, ""), version, "");
    if (std::regex_search(prose, number) && !is_written_so(line)) found.push_back(line);
  }
  return found;
}

}  // namespace

TEST_CASE("what a German number is") {
  CHECK(lines_with_points("  Verzögerung 0.5 ms").size() == 1);
  CHECK(lines_with_points("-0.5 mm").size() == 1);
  CHECK(lines_with_points("Verzögerung 0,5 ms, `fg_f0 0.5`, axisc 0.2.0, Format 1.1, x.lis:1").empty());
  CHECK(lines_with_points("    filter[0].fg_f0   80.8").empty());
  CHECK(lines_with_points("P-AXIS-00008.0 = 5000 mm/s²").empty());
  CHECK(lines_with_points("#FILTER ON [AX_DEV=0.001 SHARE=12.5]").empty());
  CHECK(without_markup("<svg d=\"1.5\"><text>2.5</text></svg><style>3.5</style>") == "\n\n2.5\n\n\n");
}

TEST_CASE("German outputs have decimal commas") {
  std::size_t files = 0;
  for (auto const& entry : fs::recursive_directory_iterator(AXISC_SOURCE_DIR "/tests/cli/data/golden")) {
    std::string const name = entry.path().filename().string();
    bool const is_german =
        name.find(".de.") != std::string::npos || name.ends_with(".de") || name.starts_with("de.");
    bool const is_data = name.ends_with(".json") || name.ends_with(".sarif") || name.ends_with(".gitlab");
    // Values as the lists have them.
    bool const is_of_lists = name == "lists.de.markdown";
    if (!is_german || is_data || is_of_lists || !entry.is_regular_file()) continue;
    ++files;
    std::string const text = file_contents(entry.path());
    INFO(entry.path());
    bool const is_markup = name.ends_with(".svg") || name.ends_with(".junit");
    CHECK(lines_with_points(is_markup ? without_markup(text) : text) == std::vector<std::string>());
  }
  CHECK(files > 25);
}

TEST_CASE("German answers have decimal commas") {
  struct Asked {
    std::string folder;
    std::vector<std::string> arguments;
  };
  std::vector<Asked> const all = {
      {"samples/mistakes", {"lint", "units.lis", "unsuitable.lis", "--pedantic", "--cycle-time", "125us"}},
      {"samples/mistakes", {"lint", "without-effect.lis", "references.lis", "typing.lis"}},
      {"samples/mill", {"lint", "machine.json", "--pedantic"}},
      {"samples/mill", {"contour", "machine.json", "--feed", "1250.5", "--radius", "12.5"}},
      {"samples/mill", {"plot", "machine.json", "--kind", "response", "--table"}},
      {"samples/mill", {"plot", "machine.json", "--kind", "delay", "--table"}},
      {"samples/mill", {"suggest", "machine.json", "--axis", "X", "--resonance", "48.5Hz"}},
      {"samples/mill", {"report", "machine.json", "--feed", "1250.5", "--radius", "12.5", "-o", "-"}},
      {"samples", {"report", "mill/machine.json", "--before", "motion/square/machine.json", "-o", "-"}},
      {"samples/controller", {"report", ".", "-o", "-"}},
      {"samples/mistakes", {"report", "controller", "-o", "-"}},
      {".", {"explain", "filter[].guete"}},
      {".", {"explain", "P-AXIS-00067"}},
      {".", {"explain", "getriebe[].dynamik.vb_max"}},
      {".", {"explain", "filter[].time_constant"}},
  };
  for (Asked const& asked : all) {
    auto arguments = asked.arguments;
    arguments.insert(arguments.end(), {"--lang", "de"});
    auto const answer = run_axisc(arguments, in_folder(AXISC_SOURCE_DIR "/" + asked.folder));
    INFO(asked.folder << ": " << arguments.front() << " " << arguments.at(1) << "\n" << answer.err);
    CHECK_FALSE(answer.out.empty());
    bool const is_page = answer.out.starts_with("<!");
    auto const text = is_page ? without_markup(without_listed_values(answer.out)) : answer.out;
    CHECK(lines_with_points(text) == std::vector<std::string>());
  }
}

TEST_CASE("a list of two that may be a number with a decimal comma is told") {
  auto const told = [](std::vector<std::string> const& arguments) {
    return run_axisc(arguments, in_folder(AXISC_SOURCE_DIR "/samples")).err;
  };
  CHECK(told({"contour", "mill", "--feed", "1500,5"}) ==
        "axisc: warning: --feed \"1500,5\" is two values, 1500 and 5; a decimal point is written \".\"\n");
  CHECK_THAT(told({"suggest", "resonance", "--axis", "X", "--resonance", "48,5Hz", "--lang", "de"}),
             Catch::Matchers::Contains("--resonance \"48,5Hz\" sind zwei Werte, 48 und 5Hz;"));
  CHECK_THAT(told({"response", "mill", "--frequencies", "48,25"}),
             Catch::Matchers::Contains("two values, 48 and 25;"));
  CHECK_THAT(told({"circle", "mill", "--feed", "1500,5", "--radius", "10"}),
             Catch::Matchers::Contains("two values"));
  for (std::string const list : {"10,20", "48,125", "48, 5", "48,5,9", "48.5,9", "48", "48,9.5", "0,50"}) {
    CHECK_THAT(told({"response", "mill", "--frequencies", list}), !Catch::Matchers::Contains("two values"));
  }
  CHECK_THAT(told({"suggest", "resonance", "--axis", "X", "--resonance", "48,5:0.02"}),
             Catch::Matchers::Contains("two values, 48 and 5:0.02;"));
}

TEST_CASE("a number with its unit is refused with the unit that it has without") {
  auto const refused =
      run_axisc({"suggest", "resonance", "--axis", "X", "--resonance", "48", "--feed", "4000mm/min"},
                in_folder(AXISC_SOURCE_DIR "/samples"));
  CHECK(refused.err ==
        "axisc: error: --feed needs numbers above 0 in mm/min, without the unit, not \"4000mm/min\"\n");
}

}  // namespace german_numbers_test
