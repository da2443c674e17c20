// The documents of the formats piece by piece: head, one element per finding, tail. A run with more findings than fit
// in memory writes them this way; the whole documents (writers.hpp) are made of the same pieces.
#pragma once

#include "diagnostics/finding.hpp"
#include "diagnostics/writers/writers.hpp"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// An element may hold these where it depends on the other findings. JSON never contains them.
inline constexpr char fingerprint_hole = '\x01';
inline constexpr char rule_index_hole = '\x02';  ///< where SARIF's list of rules names the rule

struct HoleTexts {
  std::string fingerprint = {};
  std::size_t rule_index = 0;
};

[[nodiscard]] std::string fill_holes(std::string_view element, HoleTexts const& texts);

/// A source that findings point into.
struct Artifact {
  std::string name;
  Encoding encoding = Encoding::utf8;
};

// Elements are separated by commas, and each is preceded by the line break and indentation of its format. Elements are
// appended to `text`.

[[nodiscard]] std::string json_head();
void append_json_element(std::string& text, Finding const& finding, SourceSet const& sources,
                         Language language);
/// `counts` and `codes` are those of the elements; `shard` is a JSON object of the caller's, or empty.
[[nodiscard]] std::string json_tail(bool has_elements, RunFacts const& run, FindingCounts const& counts,
                                    std::vector<CodeCount> const& codes, std::string_view shard = {});

/// `codes` and `artifacts` are those of the elements, the artifacts without repetition.
[[nodiscard]] std::string sarif_head(std::set<Code> const& codes, std::vector<Artifact> const& artifacts,
                                     ReportContext const& context, Language language);
void append_sarif_element(std::string& text, Finding const& finding, SourceSet const& sources,
                          ReportContext const& context, Language language);
[[nodiscard]] std::string sarif_tail(bool has_elements, std::string_view shard = {});
/// The index of a rule among the listed ones, for the hole.
[[nodiscard]] std::size_t rule_index(std::set<Code> const& codes, Code code, ReportContext const& context);
/// Sources of a finding's places, each once, ascending.
[[nodiscard]] std::set<SourceId> sources_of(Finding const& finding);

[[nodiscard]] std::string gitlab_element(Finding const& finding, SourceSet const& sources,
                                         ReportContext const& context, Language language);

}  // namespace axisc
