#include "cli/checking/checked_input.hpp"

namespace axisc::cli {

void FindingWriter::add(Finding const& finding) {
  counts_.add(finding.severity);
  written_.severity = finding.severity;
  written_.fixable = finding.fix.has_value();
  identify(written_.identity, finding, sources_);
  written_.text.clear();
  append_element(written_.text, finding, sources_, report_format_);
  if (report_format_.format == FindingFormat::sarif) {
    written_.artifacts.clear();
    for (auto const id : sources_of(finding)) written_.artifacts.push_back(static_cast<std::uint32_t>(id));
  }
  take_(written_);
}

std::vector<Artifact> FindingWriter::artifacts() const {
  std::vector<Artifact> artifacts;
  if (report_format_.format != FindingFormat::sarif || counts_.total() == 0) return artifacts;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    SourceText const& source = sources_[static_cast<SourceId>(i)];
    artifacts.push_back({.name = source.name(), .encoding = source.encoding()});
  }
  return artifacts;
}

std::size_t weight_of(CheckedInput const& checked) {
  std::size_t weight = sizeof(checked);
  for (auto const& finding : checked.findings) weight += sizeof(finding) + finding.text.size();
  return weight;
}

}  // namespace axisc::cli
