// What is left of an input when it was checked: its findings as they will be printed, and what the whole run needs to
// know of them. No source text stays in memory, and the same bytes can be kept in a cache.
#pragma once

#include "cli/failure.hpp"
#include "cli/fleet/byte_stream.hpp"
#include "cli/options/report_format.hpp"
#include "diagnostics/report_elements.hpp"

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
  /// In output order; none that were printed as soon as they were written.
  std::deque<WrittenFinding> findings;
  std::vector<Artifact> artifacts;  ///< the sources, where findings name them
  std::vector<std::string> files;   ///< that were read
  std::optional<Failure> failure;   ///< then there is nothing else
};

/// Takes a finding of an input; what it is given is gone afterwards.
using TakeFinding = std::function<void(WrittenFinding const&)>;
/// Keeps them.
[[nodiscard]] inline TakeFinding keep_in(std::deque<WrittenFinding>& findings) {
  return [&findings](WrittenFinding const& finding) { findings.push_back(finding); };
}

/// Writes the findings of one input, one after the other in output order. The sources may still grow.
class FindingWriter {
 public:
  FindingWriter(SourceSet const& sources, ReportFormat const& report_format, TakeFinding take)
      : sources_(sources), report_format_(report_format), take_(std::move(take)) {}

  void add(Finding const& finding);
  /// Of everything that was added.
  [[nodiscard]] FindingCounts const& counts() const { return counts_; }
  /// For CheckedInput::artifacts, when all findings are written.
  [[nodiscard]] std::vector<Artifact> artifacts() const;

 private:
  SourceSet const& sources_;
  ReportFormat const& report_format_;
  TakeFinding take_;
  FindingCounts counts_;
  WrittenFinding written_;  ///< the last one, whose memory serves the next
};

// As a cache keeps it; an input with a failure is not kept.
void write_bytes(ByteWriter& bytes, CheckedInput const& checked);
/// None where the bytes make no sense.
[[nodiscard]] std::optional<CheckedInput> read_checked_input(ByteReader& bytes);

[[nodiscard]] std::size_t weight_of(CheckedInput const& checked);

}  // namespace axisc::cli
