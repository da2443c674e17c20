#include "cli/checked_input.hpp"

#include "cli/codes.hpp"

#include <utility>

namespace axisc::cli {

void FindingWriter::add(Finding const& finding) {
  counts_.add(finding.severity);
  WrittenFinding written{.severity = finding.severity,
                         .fixable = finding.fix.has_value(),
                         .identity = identity_of(finding, sources_),
                         .artifacts = {},
                         .text = {}};
  // Many wait in memory: without room to spare.
  buffer_.clear();
  append_element(buffer_, finding, sources_, form_);
  written.text = buffer_;
  if (form_.format == FindingFormat::sarif) {
    for (auto const id : sources_of(finding)) written.artifacts.push_back(static_cast<std::uint32_t>(id));
  }
  if (finding.code == cycle_time_assumed) {
    checked_.assumption = std::move(written);
  } else {
    checked_.findings.push_back(std::move(written));
  }
}

CheckedInput FindingWriter::take() && {
  bool const names_artifacts = form_.format == FindingFormat::sarif && counts_.total() > 0;
  for (std::size_t i = 0; names_artifacts && i < sources_.size(); ++i) {
    SourceText const& source = sources_[static_cast<SourceId>(i)];
    checked_.artifacts.push_back({.name = source.name(), .encoding = source.encoding()});
  }
  return std::move(checked_);
}

std::size_t weight_of(CheckedInput const& checked) {
  std::size_t weight = sizeof(checked);
  for (auto const& finding : checked.findings) weight += sizeof(finding) + finding.text.size();
  return weight;
}

}  // namespace axisc::cli
