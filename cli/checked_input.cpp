#include "cli/checked_input.hpp"

#include "cli/codes.hpp"

#include <map>
#include <utility>

namespace axisc::cli {

namespace {

/// The sources of SARIF's list of artifacts, numbered.
std::map<SourceId, std::uint32_t> number_sources(std::vector<Finding> const& findings) {
  std::set<SourceId> used;
  for (auto const& finding : findings) used.merge(sources_of(finding));
  std::map<SourceId, std::uint32_t> numbers;
  for (auto const id : used) numbers.emplace(id, static_cast<std::uint32_t>(numbers.size()));
  return numbers;
}

}  // namespace

CheckedInput write_findings(std::vector<Finding> const& findings, SourceSet const& sources,
                            ReportForm const& form) {
  CheckedInput checked;
  bool const names_artifacts = form.format == FindingFormat::sarif;
  auto const numbers = names_artifacts ? number_sources(findings) : std::map<SourceId, std::uint32_t>{};
  for (auto const& [id, number] : numbers) {
    checked.artifacts.push_back({.name = sources[id].name(), .encoding = sources[id].encoding()});
  }
  for (auto const& finding : findings) {
    WrittenFinding written{.severity = finding.severity,
                           .fixable = finding.fix.has_value(),
                           .identity = identity_of(finding, sources),
                           .artifacts = {},
                           .text = element_of(finding, sources, form)};
    // Many wait in memory.
    written.text.shrink_to_fit();
    if (names_artifacts) {
      for (auto const id : sources_of(finding)) written.artifacts.push_back(numbers.at(id));
    }
    if (finding.code == cycle_time_assumed) {
      checked.assumption = std::move(written);
    } else {
      checked.findings.push_back(std::move(written));
    }
  }
  return checked;
}

std::size_t weight_of(CheckedInput const& checked) {
  std::size_t weight = sizeof(checked);
  for (auto const& finding : checked.findings) weight += sizeof(finding) + finding.text.size();
  return weight;
}

}  // namespace axisc::cli
