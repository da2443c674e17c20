// Runs the table of rules over lists, axes, filters, channels and programs, and decides which findings stand.
#pragma once

#include "validator/loading.hpp"
#include "validator/rule.hpp"

#include <deque>
#include <optional>
#include <vector>

namespace axisc::validator {

/// What a finding is about, for rules that silence each other on one filter or in one program.
// NOLINT below: clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
struct Subject {
  std::size_t axis = 0;
  FilterPort port = FilterPort::setpoint;
  std::uint32_t filter = 0;
  std::optional<std::size_t>
      program;  ///< index into LoadedMachine::programs: it is about that, not about a filter
  friend auto operator<=>(Subject const&, Subject const&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Findings as their rules reported them, before the engine decides.
struct ReportedFindings {
  std::deque<Finding> findings;
  std::vector<std::optional<Subject>>
      subjects;  ///< of each; none for rules that look neither at one filter nor at one program
};

struct EngineResult {
  std::vector<Finding> findings;   ///< in output order
  bool cycle_time_needed = false;  ///< a rule that needs T looked at something
};

/// Every rule over everything that was loaded. Cost: one pass of each rule over what it looks at, plus sorting.
[[nodiscard]] EngineResult run_rules(LoadedMachine const& machine, CheckOptions const& options,
                                     SourceSet const& sources);

}  // namespace axisc::validator
