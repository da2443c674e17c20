// Findings and surroundings for the tests of the formats that code hosts read.
#pragma once

#include "example_findings.hpp"
#include "support/golden.hpp"
#include "whole_report.hpp"

#include <map>
#include <string>
#include <vector>

namespace axisc::test {

/// Without its heading and the blank line below.
inline std::string embedded_page(std::string const& path) {
  std::string const text = read_source_file(path);
  return text.substr(text.find("\n\n") + 2);
}

/// The English pages of two rules, as the program embeds them.
inline Page page_of_delay() {
  static std::string const text = embedded_page("validator/rules/AX3005-delay-too-long/en.md");
  return {.english = text, .german = {}};
}
inline Page page_of_cycle_time() {
  static std::string const text = embedded_page("validator/rules/AX9006-cycle-time-assumed/en.md");
  return {.english = text, .german = {}};
}

/// One finding with everything, one with nothing but a place, one without a place; one input failed.
struct ReportExample {
  FullExample full;
  std::vector<Finding> findings;
  ReportContext context;
  std::vector<std::string> failures{"cannot read y.lis"};

  /// All of it.
  [[nodiscard]] std::string report(FindingFormat format) const {
    return whole_report(format, findings, full.sources, {}, context, {}, failures);
  }

  ReportExample() {
    Finding without_place;
    without_place.code = Code{9006};
    without_place.name = "cycle-time-assumed";
    without_place.severity = Severity::note;
    without_place.file = "x.lis";
    without_place.message = say("1 ms, 100 %: assumed");
    Finding over_lines =
        error_at(place_of(full.sources, full.list, "LOWPASS\r\nfilter[0].quality"), "two lines");
    findings = {without_place, over_lines, full.finding, full.finding};
    std::map<Identity, std::uint32_t> counts;
    for (Finding& finding : findings) finding.occurrence = ++counts[identity_of(finding, full.sources)];
    context.rules = {
        {.code = Code{1005}, .name = "unused", .severity = Severity::error, .control = "", .page = {}},
        {.code = Code{3005},
         .name = "delay-too-long",
         .severity = Severity::error,
         .control = "50663",
         .page = page_of_delay()},
        {.code = Code{9006},
         .name = "cycle-time-assumed",
         .severity = Severity::note,
         .control = "",
         .page = page_of_cycle_time()}};
    context.version = "1.2.3";
    context.paths = {.root = "/repository", .folder = "/repository/axes 1"};
  }
};

}  // namespace axisc::test
