// Parts of the answer about a difference.
#pragma once

#include "axisc/answers/difference/difference_answer.hpp"

#include <utility>
#include <vector>

namespace axisc {

/// What the sides are called: before and after, or as the two axes of one machine.
[[nodiscard]] std::pair<presentation::Words, presentation::Words> sides_of(ShownDifference const& shown);

/// A table for people: what, and how it is on either side.
[[nodiscard]] presentation::Table side_table(ShownDifference const& shown, presentation::Words what);

/// A row of side_table() where the sides differ.
void add_difference(presentation::Table& table, presentation::Words what, presentation::Value before,
                    presentation::Value after);

/// Values of parameters, and what they mean; `parameter_row` makes its rows.
[[nodiscard]] presentation::Table parameter_table(ShownDifference const& shown);
[[nodiscard]] presentation::Row parameter_row(ShownDifference const& shown, ParameterChange const& change);
/// What programs read of them.
[[nodiscard]] presentation::Table parameter_data(AxisDifference const& axis);

/// What the change of a chain, and of how the axis is driven, does, for people; empty without a change.
[[nodiscard]] presentation::Table effects_table(ShownDifference const& shown, AxisDifference const& axis);
/// What programs read of it.
[[nodiscard]] std::vector<presentation::Block> effects_data(ShownDifference const& shown,
                                                            image::ChainDifference const& chain);

/// How the axis is driven on either side, for programs.
[[nodiscard]] presentation::Section motion_data(MotionDifference const& motion);

/// Sections of axes, for people. Those that differ alike stand together, after what a line of the default
/// list changes for several.
[[nodiscard]] std::vector<presentation::Section> axis_sections(ShownDifference const& shown);

/// "axis X (number 1, achsmds1.lis)".
[[nodiscard]] presentation::Words axis_title(ShownDifference const& shown, ComparedAxis const& was,
                                             ComparedAxis const& is);

/// What programs read of every axis.
[[nodiscard]] presentation::Sections axes_data(ShownDifference const& shown);

}  // namespace axisc
