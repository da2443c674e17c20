// What is left of an input when it was checked: its findings as they will be printed, and what the whole run needs to
// know of them. No source text stays in memory, and the same bytes can be kept in a cache.
#pragma once

#include "cli/byte_stream.hpp"
#include "cli/failure.hpp"
#include "cli/report_form.hpp"
#include "diagnostics/report_elements.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
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
  std::deque<WrittenFinding> findings;
  std::optional<WrittenFinding> assumption;  ///< AX9006, which is said once per run; not among `findings`
  std::vector<Artifact> artifacts;           ///< the sources, where findings name them
  std::vector<std::string> files;            ///< that were read
  std::optional<Failure> failure;            ///< then there is nothing else
};

/// Writes the findings of one input, one after the other in output order. The sources may still grow.
class FindingWriter {
 public:
  FindingWriter(SourceSet const& sources, ReportForm const& form) : sources_(sources), form_(form) {}

  void add(Finding const& finding);
  /// Of everything that was added.
  [[nodiscard]] FindingCounts const& counts() const { return counts_; }
  [[nodiscard]] CheckedInput take() &&;

 private:
  SourceSet const& sources_;
  ReportForm const& form_;
  FindingCounts counts_;
  CheckedInput checked_;
  std::string buffer_;
};

// As a cache keeps it; an input with a failure is not kept.
void write_bytes(ByteWriter& bytes, CheckedInput const& checked);
/// None where the bytes make no sense.
[[nodiscard]] std::optional<CheckedInput> read_checked_input(ByteReader& bytes);

[[nodiscard]] std::size_t weight_of(CheckedInput const& checked);

}  // namespace axisc::cli
