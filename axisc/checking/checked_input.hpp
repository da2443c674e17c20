// The result of checking one input.
#pragma once

#include "axisc/environment/failure.hpp"
#include "diagnostics/finding.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct CheckedInput {
  SourceSet sources;               ///< that the findings point into
  std::deque<Finding> findings;    ///< in output order; without those that were taken at once
  FindingCounts elsewhere;         ///< in files of the machine that are not shown
  std::vector<std::string> files;  ///< files that were read, or those of them that are shown
  std::optional<Failure> failure;  ///< then there is nothing else
};

/// Receives a finding of an input; the sources hold every text that it points into.
using TakeFinding = std::function<void(Finding&& finding, SourceSet const& sources)>;

/// About as many bytes as a result occupies.
[[nodiscard]] std::size_t weight_of(CheckedInput const& checked);

}  // namespace axisc
