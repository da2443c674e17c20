#include "cli/checking/checked_input.hpp"

#include <utility>

namespace axisc::cli {

namespace {

void write(ByteWriter& bytes, WrittenFinding const& finding) {
  bytes.number(static_cast<std::uint64_t>(finding.identity.code));
  bytes.text(finding.identity.file);
  bytes.text(finding.identity.axis);
  bytes.text(finding.identity.parameter);
  bytes.number(static_cast<std::uint64_t>(finding.severity));
  bytes.number(finding.fixable ? 1 : 0);
  bytes.number(finding.artifacts.size());
  for (auto const artifact : finding.artifacts) bytes.number(artifact);
  bytes.text(finding.text);
}

WrittenFinding read_finding(ByteReader& bytes) {
  WrittenFinding finding;
  finding.identity.code = static_cast<Code>(bytes.number());
  finding.identity.file = bytes.text();
  finding.identity.axis = bytes.text();
  finding.identity.parameter = bytes.text();
  finding.severity = static_cast<Severity>(bytes.number());
  finding.fixable = bytes.number() != 0;
  for (auto left = bytes.count(); left > 0; --left) {
    finding.artifacts.push_back(static_cast<std::uint32_t>(bytes.number()));
  }
  finding.text = bytes.text();
  return finding;
}

bool is_sound(WrittenFinding const& finding, std::size_t artifacts) {
  for (auto const artifact : finding.artifacts) {
    if (artifact >= artifacts) return false;
  }
  return finding.severity <= Severity::note;
}

}  // namespace

void write_bytes(ByteWriter& bytes, CheckedInput const& checked) {
  bytes.number(checked.artifacts.size());
  for (auto const& artifact : checked.artifacts) {
    bytes.text(artifact.name);
    bytes.number(static_cast<std::uint64_t>(artifact.encoding));
  }
  bytes.number(checked.files.size());
  for (auto const& file : checked.files) bytes.text(file);
  bytes.number(checked.findings.size());
  for (auto const& finding : checked.findings) write(bytes, finding);
}

std::optional<CheckedInput> read_checked_input(ByteReader& bytes) {
  CheckedInput checked;
  for (auto left = bytes.count(); left > 0; --left) {
    Artifact artifact{.name = std::string(bytes.text())};
    artifact.encoding = static_cast<Encoding>(bytes.number());
    checked.artifacts.push_back(std::move(artifact));
  }
  for (auto left = bytes.count(); left > 0; --left) checked.files.emplace_back(bytes.text());
  bool sound = true;
  for (auto left = bytes.count(); left > 0; --left) {
    checked.findings.push_back(read_finding(bytes));
    sound = sound && is_sound(checked.findings.back(), checked.artifacts.size());
  }
  if (!sound || !bytes.ok()) return std::nullopt;
  return checked;
}

}  // namespace axisc::cli
