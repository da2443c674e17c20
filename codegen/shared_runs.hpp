// Runs of equal records, stored once.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace axisc::codegen {

/// Consecutive records of a section; an empty range begins at 0.
struct Range {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// Runs of records of which equal ones are stored once.
template <class Run>
class SharedRuns {
 public:
  /// The place of `run`; calls `append` for each record of a run that is not stored yet and gets place
  /// `next`.
  template <class Append>
  Range place(Run const& run, std::uint32_t count, std::uint32_t next, Append append) {
    if (count == 0) return {};
    auto const known =
        std::find_if(runs_.begin(), runs_.end(), [&](Entry const& entry) { return entry.run == run; });
    if (known != runs_.end()) return {.first = known->first, .count = count};
    runs_.push_back({.run = run, .first = next});
    for (std::uint32_t i = 0; i < count; ++i) append(i);
    return {.first = next, .count = count};
  }

 private:
  struct Entry {
    Run run;
    std::uint32_t first = 0;
  };
  std::vector<Entry> runs_;
};

}  // namespace axisc::codegen
