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
  /// Failure for a file that cannot be read or is no baseline.
  [[nodiscard]] static Baseline read(std::string const& path);

  /// Of findings that are numbered. What is said about the run (AX9…) is left out: it accuses no list.
  void add(Identity const& identity, std::uint32_t occurrence);
  void remove(Identity const& identity, std::uint32_t occurrence);

  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] bool holds(Identity const& identity, std::uint32_t occurrence) const;
  /// The same, whatever the occurrence.
  [[nodiscard]] bool mentions(Identity const& identity) const;
  [[nodiscard]] std::vector<Identity> identities() const;
  [[nodiscard]] std::set<BaselineEntry> const& entries() const { return entries_; }

 private:
  std::set<BaselineEntry> entries_;
};

}  // namespace axisc::cli
