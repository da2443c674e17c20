// Reports of findings that are in memory.
#pragma once

#include "diagnostics/fingerprint.hpp"
#include "diagnostics/writers/report_writer.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace axisc::test {

/// The codes that were reported, the most frequent first.
inline std::vector<CodeCount> count_codes(std::vector<Finding> const& findings) {
  std::map<Code, CodeCount> by_code;
  for (Finding const& finding : findings) {
    CodeCount& row = by_code[finding.code];
    row.code = finding.code;
    row.name = finding.name;
    ++row.count;
    if (finding.fix) ++row.fixable;
  }
  std::vector<CodeCount> counts;
  for (auto const& [code, row] : by_code) counts.push_back(row);
  most_frequent_first(counts);
  return counts;
}

/// The report of one input. `finding.occurrence` must be numbered where the format has fingerprints.
inline std::string whole_report(FindingFormat format, std::vector<Finding> const& findings,
                                SourceSet const& sources, WriteOptions const& options = {},
                                ReportContext context = {}, RunFacts run = {},
                                std::vector<std::string> const& failures = {}) {
  auto const writer = report_writer(format, options, std::move(context));
  std::string text;
  writer->begin(text);
  for (auto const& failure : failures) writer->add_failure(failure);
  for (auto const& finding : findings) writer->add(text, finding, sources, fingerprint(finding, sources));
  writer->end_input(sources);
  run.counts = count(findings);
  run.codes = count_codes(findings);
  writer->end([&text](std::string_view piece) { text += piece; }, run);
  return text;
}

inline std::string write_json(std::vector<Finding> const& findings, SourceSet const& sources, RunFacts run,
                              WriteOptions const& options) {
  return whole_report(FindingFormat::json, findings, sources, options, {}, std::move(run));
}

}  // namespace axisc::test
