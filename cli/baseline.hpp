// Findings that are known and accepted: hidden from then on, so that old lists can be checked for what is new.
//
// A JSON file with one line per finding, sorted by axis, parameter and code, so that differences read well:
//     {"version": 1, "findings": [
//       {"code": "AX3005", "axis": "X", "parameter": "filter[0].time_constant", "occurrence": 1, "fingerprint": "…"}
//     ]}
// What counts is code, axis, parameter and occurrence; the fingerprint is there to be searched for.
#pragma once

#include "diagnostics/fingerprint.hpp"

#include <compare>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace axisc::cli {

struct BaselineEntry {
  std::string axis;
  std::string parameter;
  Code code{};
  std::uint32_t occurrence = 1;
  // clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
  friend auto operator<=>(BaselineEntry const&,
                          BaselineEntry const&) = default;  // NOLINT(modernize-use-nullptr)
};

class Baseline {
 public:
  Baseline() = default;
  /// Of findings that are numbered. What is said about the run (AX9…) is left out: it accuses no list.
  Baseline(std::vector<Finding> const& findings, SourceSet const& sources);
  /// Failure for a file that cannot be read or is no baseline.
  [[nodiscard]] static Baseline read(std::string const& path);

  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] bool holds(Finding const& finding, SourceSet const& sources) const;
  /// The same, whatever the occurrence.
  [[nodiscard]] bool mentions(Finding const& finding, SourceSet const& sources) const;

  /// Removes the findings that it holds; returns how many.
  std::size_t hide(std::vector<Finding>& findings, SourceSet const& sources) const;
  /// The entries that none of the findings answers to.
  [[nodiscard]] std::vector<Identity> stale(std::vector<Finding> const& findings,
                                            SourceSet const& sources) const;

 private:
  std::set<BaselineEntry> entries_;
};

}  // namespace axisc::cli
