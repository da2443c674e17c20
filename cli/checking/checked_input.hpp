// The result of checking one input: its findings as they will be printed, and the facts that the whole run needs. It
// holds no source text, and can be stored in a cache.
#pragma once

#include "cli/failure.hpp"
#include "cli/fleet/byte_stream.hpp"
#include "cli/options/report_format.hpp"
#include "diagnostics/writers/report_elements.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::cli {

struct WrittenFinding {
  Severity severity = Severity::error;
  bool fixable = false;
  Identity identity;
  std::vector<std::uint32_t> artifacts;  ///< into CheckedInput::artifacts, ascending; only for SARIF
  std::string text;                      ///< with holes
};

struct CheckedInput {
  /// In output order; without those that were printed at once.
  std::deque<WrittenFinding> findings;
  std::vector<Artifact> artifacts;  ///< the sources, where findings name them
  std::vector<std::string> files;   ///< that were read
  std::optional<Failure> failure;   ///< then there is nothing else
};

/// Receives a finding of an input; the argument is valid only during the call.
using TakeFinding = std::function<void(WrittenFinding const&)>;
/// Collects the findings in `findings`.
[[nodiscard]] inline TakeFinding keep_in(std::deque<WrittenFinding>& findings) {
  return [&findings](WrittenFinding const& finding) { findings.push_back(finding); };
}

/// Writes the findings of one input in output order. Sources may still be added meanwhile.
class FindingWriter {
 public:
  FindingWriter(SourceSet const& sources, ReportFormat const& report_format, TakeFinding take)
      : sources_(sources), report_format_(report_format), take_(std::move(take)) {}

  void add(Finding const& finding);
  /// Counts of all findings added.
  [[nodiscard]] FindingCounts const& counts() const { return counts_; }
  /// For CheckedInput::artifacts; call it after the last finding.
  [[nodiscard]] std::vector<Artifact> artifacts() const;

 private:
  SourceSet const& sources_;
  ReportFormat const& report_format_;
  TakeFinding take_;
  FindingCounts counts_;
  WrittenFinding written_;  ///< the last one, whose memory serves the next
};

// The form stored in a cache; an input with a failure is not stored.
void write_bytes(ByteWriter& bytes, CheckedInput const& checked);
/// None if the bytes are invalid.
[[nodiscard]] std::optional<CheckedInput> read_checked_input(ByteReader& bytes);

[[nodiscard]] std::size_t weight_of(CheckedInput const& checked);

}  // namespace axisc::cli
