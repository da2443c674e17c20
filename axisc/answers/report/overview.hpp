// The first table of a report: what the filters of each axis are, and what they cost. Axes that filter alike
// are one.
#pragma once

#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/report/report_page.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// Axes whose setpoints have the same filters, and the same delays after them, in both states where there are
/// two.
struct EqualAxes {
  std::vector<std::size_t> axes;  ///< of the image, at least one
  std::string names;              ///< "X, Y, Z"
};

/// In the order of the axes.
[[nodiscard]] std::vector<EqualAxes> equal_axes(PlotSubject const& subject);

/// What some axes cost. Deviations are those of `contour` at the highest feed, the largest of the axes; none
/// of axes that no channel moves along a path.
struct AxisCost {
  double delay_ms = 0;                  ///< of the position, all filters on
  std::optional<double> start_ms = {};  ///< as long as no command switched a filter on, where that differs
  std::optional<double> corner_um = {}, passed_um = {}, circle_um = {};

  [[nodiscard]] double largest_um() const { return std::max(corner_um.value_or(0), circle_um.value_or(0)); }
};
[[nodiscard]] AxisCost cost_of(ReportSubject const& subject, EqualAxes const& axes);

/// The tolerance less the larger of the deviations at corner and circle; none without a tolerance.
[[nodiscard]] std::optional<double> margin_um(ReportSubject const& subject, AxisCost const& cost);

enum class OverviewOrder : std::uint8_t { of_axes, costliest_first };

/// A row for axes that are alike. Empty after errors.
[[nodiscard]] presentation::Table overview_table(ReportSubject const& subject,
                                                 OverviewOrder order = OverviewOrder::of_axes);

/// What the filters cost: of one channel in sentences, of several as a table.
[[nodiscard]] ReportBlocks cost_blocks(ReportSubject const& subject);

}  // namespace axisc
