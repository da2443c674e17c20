// Whether the positions of two axes that must move alike arrive together, and alike: master and slave of a
// gantry, coupled axes.
#pragma once

#include "validator/rules/group_delays.hpp"

#include <cstddef>
#include <optional>

namespace axisc::validator::checks {

struct AxisPair {
  DelayedAxis const& master;
  DelayedAxis const& slave;
};

struct PositionDifference {
  AxisPair pair;
  double cycles = 0;        ///< the largest difference of delays that start-up or `#FILTER` may bring about
  DelayedAxis const& axis;  ///< that has what makes the difference, the slave if in doubt
  EffectiveValue const& cause;
  bool filters_differ = true;
  bool feedforward_differs = false;  ///< what delays the positions after the filters

  /// The delays differ, not only the responses.
  [[nodiscard]] bool is_apart() const;
};

/// None for an axis whose delay is unknown.
[[nodiscard]] std::optional<DelayedAxis> delayed_axis(MachineContext const& context, std::size_t index);

/// None where the filters do the same, whatever their order, and nothing after them differs. The pair
/// outlives the result.
[[nodiscard]] std::optional<PositionDifference> compare_positions(AxisPair pair);

/// A finding at what makes the difference, with the delays of both axes. The headline may name
/// {master}, {slave}, {cycles} and {milliseconds}.
Finding& report_difference(PositionDifference const& difference, SentenceRef headline,
                           MachineContext const& context, Report& report);

}  // namespace axisc::validator::checks
