// Walks over the folders of the rules: each has a row in the table, a page in both languages, a sample that
// it reports and one that it passes.
//
// The samples are in the rule's folder. `fail.lis` is a list, for rules about NC programs `fail.nc`, or a
// folder `fail` with machine.json or hochlauf.lis where a machine is needed; the same with `pass`.
// `fail.expected` holds the findings in output order, `line:column CODE`, in other files than the input
// `file:line:column CODE`, without place `- CODE`. A first line
// `# test: --cycle-time 1ms --pedantic` gives options, in a folder that of x.lis or hochlauf.lis;
// `--in-folder` and
// `--beside-start-up-list` say where the list was found.
#include "diagnostics/message.hpp"
#include "support/catch.hpp"
#include "support/file_contents.hpp"
#include "support/golden.hpp"
#include "support/map_files.hpp"
#include "validator/check.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace axisc;
namespace fs = std::filesystem;

constexpr char const* folder_of_rules = "validator/rules/";

validator::CheckOptions options_of(std::string const& text) {
  validator::CheckOptions options;
  constexpr std::string_view mark = "# test:";
  if (text.substr(0, mark.size()) != mark) return options;
  std::istringstream words(text.substr(mark.size(), text.find('\n') - mark.size()));
  for (std::string word; words >> word;) {
    if (word == "--pedantic") {
      options.pedantic = true;
      continue;
    }
    if (word == "--in-folder" || word == "--beside-start-up-list") {
      options.from_folder = true;
      options.is_beside_start_up_list = word == "--beside-start-up-list";
      continue;
    }
    std::string value;
    REQUIRE(words >> value);
    if (word == "--cycle-time") {
      double const factor = value.find("ms") != std::string::npos ? 1e6 : 1e3;
      options.cycle_time = design::CycleTime{static_cast<std::uint32_t>(std::stod(value) * factor)};
    } else if (word == "--axis-type") {
      options.axis_type = value == "S"   ? machine::AxisType::spindle
                          : value == "R" ? machine::AxisType::rotary
                                         : machine::AxisType::translatory;
    } else if (word == "--build") {
      options.build = validator::parse_build_version(value);
    } else {
      FAIL("unknown option of a sample: " << word);
    }
  }
  return options;
}

struct Outcome {
  std::string findings;  ///< in the form of the expected file
  bool contains_code = false;
  bool texts_complete = true;
  std::string silent_messages;  ///< the control's numbers that stand without what it does
};

Outcome outcome_of(validator::CheckResult const& result, SourceSet const& sources, std::string const& input,
                   Code code) {
  Outcome outcome;
  for (Finding const& finding : result.findings) {
    outcome.contains_code = outcome.contains_code || finding.code == code;
    for (Language const language : {Language::english, Language::german}) {
      std::string const text = render(finding.message, language);
      outcome.texts_complete = outcome.texts_complete && !text.empty() && text.find('{') == std::string::npos;
    }
    if (finding.control) {
      auto const& control = *finding.control;
      if (!control.message.empty() && !control.reaction) outcome.silent_messages += control.message + " ";
    }
    if (finding.place) {
      SourceText const& source = sources[finding.place->source];
      Position const position = source.position(finding.place->span.begin);
      if (source.name() != input) outcome.findings += source.name() + ":";
      outcome.findings += std::to_string(position.line) + ":" + std::to_string(position.column);
    } else {
      outcome.findings += "-";
    }
    outcome.findings += " " + code_text(finding.code) + "\n";
  }
  return outcome;
}

/// The folders of the rules, by rising code: "AX3005-delay-too-long".
std::vector<std::string> rule_folders() {
  std::vector<std::string> folders;
  for (fs::directory_entry const& entry :
       fs::directory_iterator(fs::path(AXISC_SOURCE_DIR) / folder_of_rules)) {
    if (entry.is_directory()) folders.push_back(entry.path().filename().string());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

std::string folder_of(validator::Rule const& rule) {
  return code_text(rule.code) + "-" + std::string(rule.name);
}

/// The files of a sample, and how they are checked.
struct Sample {
  std::map<std::string, std::string> contents;
  std::string input;
  validator::CheckOptions options;
};

/// `name`: "fail" or "pass".
Sample read_sample(validator::Rule const& rule, std::string const& name) {
  fs::path const folder = fs::path(AXISC_SOURCE_DIR) / folder_of_rules / folder_of(rule);
  fs::path const base = folder / name;
  Sample sample;
  auto& [contents, input, options] = sample;
  input = name + (fs::exists(base.string() + ".nc") ? ".nc" : ".lis");
  if (fs::is_directory(base)) {
    input = fs::exists(base / "hochlauf.lis") ? "hochlauf.lis" : "machine.json";
    for (fs::directory_entry const& entry : fs::directory_iterator(base)) {
      contents[entry.path().filename().string()] = test::file_contents(entry.path());
    }
    options = options_of(contents[input == "machine.json" ? "x.lis" : input]);
  } else {
    contents[input] = test::file_contents(folder / input);
    options = options_of(contents[input]);
  }
  return sample;
}

std::vector<Finding> findings_of(Sample const& sample) {
  tests::MapFiles files(sample.contents);
  SourceSet sources;
  return validator::check(files, sample.input, sample.options, sources).findings;
}

Outcome run_sample(validator::Rule const& rule, std::string const& name) {
  Sample const sample = read_sample(rule, name);
  tests::MapFiles files(sample.contents);
  SourceSet sources;
  validator::CheckResult const result = validator::check(files, sample.input, sample.options, sources);
  CHECK_FALSE(result.unreadable.has_value());
  return outcome_of(result, sources, sample.input, rule.code);
}

/// Codes of files and environment come from the program itself; its own tests show them.
bool has_sample(validator::Rule const& rule) {
  auto const number = static_cast<std::uint16_t>(rule.code);
  return number < 9000 || number == 9006;
}

}  // namespace

TEST_CASE("every folder is a rule, and every rule has a page in both languages") {
  std::vector<std::string> folders;
  for (validator::Rule const& rule : validator::rules()) {
    INFO(code_text(rule.code) << " " << rule.name);
    folders.push_back(folder_of(rule));
    CHECK_FALSE(page(rule).english.empty());
    CHECK_FALSE(page(rule).german.empty());
  }
  CHECK(folders == rule_folders());
}

TEST_CASE("the table is in order and every code is there once") {
  validator::Rule const* previous = nullptr;
  std::size_t number = 0;
  for (validator::Rule const& rule : validator::rules()) {
    INFO(code_text(rule.code));
    CHECK_FALSE(rule.name.empty());
    CHECK(validator::find_rule(rule.code) == &rule);
    CHECK(validator::number_of(rule) == number++);
    if (previous != nullptr) CHECK(previous->code < rule.code);
    for (Code const code : rule.silenced_by) CHECK(validator::find_rule(code) != nullptr);
    previous = &rule;
  }
  CHECK(number == validator::rules().size());
  CHECK(validator::find_rule(Code{4999}) == nullptr);
  CHECK(validator::find_rule(Code{65535}) == nullptr);
}

TEST_CASE("every rule reports its failing sample, exactly as expected") {
  for (validator::Rule const& rule : validator::rules()) {
    if (!has_sample(rule)) continue;
    INFO(folder_of(rule));
    Outcome const outcome = run_sample(rule, "fail");
    CHECK(outcome.contains_code);
    CHECK(outcome.texts_complete);
    CHECK(outcome.silent_messages.empty());
    test::check_golden(folder_of_rules + folder_of(rule) + "/fail.expected", outcome.findings);
  }
}

TEST_CASE("every rule passes its passing sample") {
  for (validator::Rule const& rule : validator::rules()) {
    if (!has_sample(rule)) continue;
    INFO(folder_of(rule));
    Outcome const outcome = run_sample(rule, "pass");
    INFO(outcome.findings);
    CHECK_FALSE(outcome.contains_code);
  }
}

namespace {

std::size_t count(std::vector<Finding> const& findings, Code code) {
  return static_cast<std::size_t>(std::count_if(
      findings.begin(), findings.end(), [code](Finding const& finding) { return finding.code == code; }));
}

/// A rule about the text of lists, not about values of parameters.
bool is_about_text(validator::Rule const& rule) {
  auto const number = static_cast<std::uint16_t>(rule.code);
  bool const is_reference = number >= 2010 && number <= 2014;
  return number < 2002 || number == 2006 || is_reference || number >= 9000;
}

bool looks_at(validator::Rule const& rule, std::string const& parameter) {
  auto const found = schema::find(parameter);
  return found.row == nullptr || validator::looks_at(rule, *found.row);
}

/// The parameter that a line assigns; empty for other lines.
std::string assigned(std::string const& line) {
  auto const name = line.substr(0, line.find_first_of(" \t"));
  return schema::find(name).row == nullptr ? std::string() : name;
}

}  // namespace

TEST_CASE("a rule names the parameters of its findings, and those whose lines decide about them") {
  for (validator::Rule const& rule : validator::rules()) {
    if (!has_sample(rule) || is_about_text(rule)) continue;
    for (std::string const name : {"fail", "pass"}) {
      Sample const sample = read_sample(rule, name);
      auto const findings = findings_of(sample);
      for (auto const& finding : findings) {
        INFO(folder_of(rule) << ": " << finding.parameter);
        if (finding.code == rule.code) CHECK(looks_at(rule, finding.parameter));
      }
      for (auto const& [file, text] : sample.contents) {
        if (!file.ends_with(".lis")) continue;
        for (std::size_t begin = 0; begin < text.size();) {
          auto const end = std::min(text.find('\n', begin), text.size() - 1) + 1;
          auto const parameter = assigned(text.substr(begin, end - begin));
          if (!parameter.empty() && !looks_at(rule, parameter)) {
            Sample without = sample;
            without.contents[file].erase(begin, end - begin);
            INFO(folder_of(rule) << "/" << name << " without " << parameter);
            CHECK(count(findings_of(without), rule.code) == count(findings, rule.code));
          }
          begin = end;
        }
      }
    }
  }
}

TEST_CASE("the parameters that rules name are in the catalogue") {
  for (validator::Rule const& rule : validator::rules()) {
    std::istringstream words{std::string(rule.parameters)};
    for (std::string word; words >> word;) {
      validator::Rule alone;
      alone.parameters = word;
      auto const rows = schema::parameters();
      INFO(folder_of(rule) << ": " << word);
      CHECK(std::any_of(rows.begin(), rows.end(),
                        [&](auto const& row) { return validator::looks_at(alone, row); }));
    }
  }
}

// A finding without help and fix is one whose message, label or note states what is allowed.
TEST_CASE("every finding says what to write instead") {
  std::set<std::uint16_t> const stated = {2002, 2003, 2004, 2005, 2007, 3037, 4020, 5001, 5002, 5012, 8002};
  for (validator::Rule const& rule : validator::rules()) {
    if (!has_sample(rule)) continue;
    auto const number = static_cast<std::uint16_t>(rule.code);
    for (auto const& finding : findings_of(read_sample(rule, "fail"))) {
      if (finding.code != rule.code || stated.contains(number)) continue;
      INFO(folder_of(rule) << ": " << render(finding.message, Language::english));
      CHECK((!finding.help.empty() || finding.fix.has_value()));
    }
  }
}
