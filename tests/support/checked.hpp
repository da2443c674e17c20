// A check on files in memory, its findings as short text.
#pragma once

#include "support/map_files.hpp"
#include "validator/check.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace axisc::tests {

inline constexpr design::CycleTime one_millisecond{1'000'000};

[[nodiscard]] inline validator::CheckOptions with_cycle_time() {
  validator::CheckOptions options;
  options.cycle_time = one_millisecond;
  return options;
}

class Checked {
 public:
  /// One list, with T = 1 ms unless the options say otherwise.
  explicit Checked(std::string const& list, validator::CheckOptions const& options = with_cycle_time())
      : Checked(std::map<std::string, std::string>{{"x.lis", list}}, "x.lis", options) {}
  Checked(std::map<std::string, std::string> contents, std::string const& input,
          validator::CheckOptions const& options = with_cycle_time())
      : files(std::move(contents)), input_(input), result(validator::check(files, input, options, sources)) {}

  /// "line:column CODE" per finding, in output order; findings in other files begin with their name.
  [[nodiscard]] std::vector<std::string> found() const {
    std::vector<std::string> lines;
    for (Finding const& finding : result.findings)
      lines.push_back(place_text(finding) + code_text(finding.code));
    return lines;
  }

  [[nodiscard]] std::string place_text(Finding const& finding) const {
    if (!finding.place) return "- ";
    SourceText const& source = sources[finding.place->source];
    Position const position = source.position(finding.place->span.begin);
    std::string const file = source.name() == input_ ? "" : source.name() + ":";
    return file + std::to_string(position.line) + ":" + std::to_string(position.column) + " ";
  }

  SourceSet sources;
  MapFiles files;

 private:
  std::string input_;

 public:
  validator::CheckResult result;
};

using Lines = std::vector<std::string>;

}  // namespace axisc::tests
