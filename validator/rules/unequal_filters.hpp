// Whether the filters of two axes that must move alike do the same: master and slave of a gantry, coupled
// axes.
#pragma once

#include "validator/rules/group_delays.hpp"

#include <cstddef>
#include <optional>

namespace axisc::validator::checks {

struct AxisPair {
  DelayedAxis const& master;
  DelayedAxis const& slave;
};

struct FilterDifference {
  AxisPair pair;
  double cycles = 0;        ///< the largest difference of delays that start-up or `#FILTER` may bring about
  DelayedAxis const& axis;  ///< that has the filter that makes the difference, the slave if in doubt
  DelayShare const& filter;

  /// The delays differ, not only the responses.
  [[nodiscard]] bool is_apart() const;
};

/// None for an axis whose delay is unknown.
[[nodiscard]] std::optional<DelayedAxis> delayed_axis(MachineContext const& context, std::size_t index);

/// None where the filters do the same, whatever their order. The pair outlives the result.
[[nodiscard]] std::optional<FilterDifference> compare_filters(AxisPair pair);

/// A finding at the filter that makes the difference, with the delays of both axes. The headline may name
/// {master}, {slave}, {cycles} and {milliseconds}.
Finding& report_difference(FilterDifference const& difference, SentenceRef headline,
                           MachineContext const& context, Report& report);

}  // namespace axisc::validator::checks
