// A baseline: known and accepted findings, hidden so that only new ones are reported.
//
// A JSON file with one line per finding, sorted by file, axis, parameter and code for readable diffs:
//     {"version": 2, "findings": [
//       {"file": "axes/x.lis", "code": "AX3005", "axis": "X", "parameter": "filter[0].time_constant",
//        "occurrence": 1, "fingerprint": "…"}
//     ]}
// An entry is identified by file, code, axis, parameter and occurrence; the fingerprint is only for text
// searches. The file is named as in its repository: see identity_paths.hpp.
#pragma once

#include "diagnostics/fingerprint.hpp"

#include <compare>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace axisc {

struct BaselineEntry {
  Identity identity;
  std::uint32_t occurrence = 1;
  // clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
  friend auto operator<=>(BaselineEntry const&,
                          BaselineEntry const&) = default;  // NOLINT(modernize-use-nullptr)
};

class Baseline {
 public:
  Baseline() = default;
  /// Failure for a file that cannot be read or is not a baseline.
  [[nodiscard]] static Baseline read(std::string const& path);

  /// A baseline of numbered findings. Findings about the run itself (AX9…) are left out: they do not concern
  /// a list.
  void add(Identity const& identity, std::uint32_t occurrence);
  void remove(Identity const& identity, std::uint32_t occurrence);

  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] bool holds(Identity const& identity, std::uint32_t occurrence) const;
  /// True if an entry matches the finding in everything but the occurrence.
  [[nodiscard]] bool mentions(Identity const& identity) const;
  [[nodiscard]] std::vector<Identity> identities() const;
  [[nodiscard]] std::set<BaselineEntry> const& entries() const { return entries_; }

 private:
  std::set<BaselineEntry> entries_;
};

}  // namespace axisc
