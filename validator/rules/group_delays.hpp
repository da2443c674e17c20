// The delay of each axis of a channel. Different delays distort the contour.
#pragma once

#include "validator/engine/rule.hpp"
#include "validator/views/axis_delay.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axisc::validator::checks {

/// In cycles: delays that differ by less count as equal.
inline constexpr double noticeable_delay = 0.5;

struct DelayedAxis {
  LoadedAxis const& axis;
  AxisDelay delay;
  double after_filters = 0;  ///< see delay_after_filters()
};

using Delays = std::vector<DelayedAxis>;

/// The axes whose delay is known; none for a channel of one axis. Gantry slaves are compared with their
/// masters (AX4021).
[[nodiscard]] Delays delays_of(GroupContext const& context);

/// The same axes with the filters that work from start-up alone.
[[nodiscard]] Delays at_start(Delays delays);

[[nodiscard]] bool less_delayed(DelayedAxis const& left, DelayedAxis const& right);

/// The least and the most delayed axis after the filters; null without axes.
[[nodiscard]] std::pair<DelayedAxis const*, DelayedAxis const*> extremes_after_filters(Delays const& delays);

/// Cycles between the axis that is delayed least and the one that is delayed most.
[[nodiscard]] double spread(Delays const& delays);

/// Index of the axis whose cause is last in the lists; none where no list delays anything.
[[nodiscard]] std::optional<std::size_t> last_cause(Delays const& delays);

/// Cycles for display: "1 cycle", "2.5 cycles".
[[nodiscard]] Wording counted_cycles(double cycles);

/// States the delay of an axis, and what each of its filters contributes.
[[nodiscard]] Message delay_of(DelayedAxis const& axis);
/// States what delays the position of an axis after its filters.
[[nodiscard]] Message delay_after_filters_of(DelayedAxis const& axis);
/// The last line of the axis that says something about feedforward; null where no list does.
[[nodiscard]] EffectiveValue const* line_about_feedforward(LoadedAxis const& axis);
/// "`filter[1]` 3.907, `filter_fir` 20".
[[nodiscard]] Wording shares_text(AxisDelay const& delay);

/// The filter of `axis` whose share differs most from that of the same filter in `other`, and that a list
/// sets, in doubt the later one; null where `axis` has none.
[[nodiscard]] DelayShare const* largest_difference(AxisDelay const& axis, AxisDelay const& other);

/// Points to the filters that delay the axes other than `reported`.
void relate_others(Finding& finding, Delays const& delays, std::size_t reported);

}  // namespace axisc::validator::checks
